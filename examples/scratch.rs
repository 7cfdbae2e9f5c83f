//! Renders every sign of the given `.sign` files to out/<stem>-<name>.html: `scratch OUT_DIR FILE...`
use chereme::synthesis::*;
use chereme::notation::*;
fn main() {
    let signer = chereme::avatar::signer().unwrap();
    let g = Grammar::builtin();
    let vocabulary = vocabulary::Vocabulary::of(&g.handshapes, &g.locations, &g.expressions);
    let mut args = std::env::args().skip(1);
    let dir = args.next().expect("OUT_DIR");
    let mut only: Vec<String> = vec![];
    let mut files = vec![];
    for a in args { if let Some(n) = a.strip_prefix("--only=") { only = n.split(',').map(str::to_string).collect() } else { files.push(a) } }
    std::fs::create_dir_all(&dir).unwrap();
    let mut plan = vec![];
    for file in files {
        let bytes = std::fs::read(&file).unwrap();
        let (source, fault) = read::source_of_bytes(&file, &bytes);
        let reading = read::read(&source.text, &vocabulary, lexicon::language_of_path(&file));
        for d in fault.iter().chain(&reading.diagnostics) { eprintln!("{}", chereme::diagnostics::render::render(d, &source, false)); }
        for s in reading.signs {
            let s = s.sign;
            if !only.is_empty() && !only.contains(&s.name) { continue; }
            match synthesize(&s, &g, &signer, &Options::default()) {
                Err(e) => eprintln!("FAILED {e}"),
                Ok(p) => {
                    let r = &p.report;
                    println!("{:14} {:5.2}s keys {:?} v {:.2} residual {:.1}mm tilt {:.0}° {:?}", s.name, p.track.clip.duration().0, r.keys.iter().map(|k| (k.0*100.0).round()/100.0).collect::<Vec<_>>(), r.wrist_speed, r.residual_m*1e3, r.tilt.to_degrees(), r.warnings);
                    let page = chereme::format::html::Page { title: s.name.clone(), language: s.language.clone(), facts: vec![] };
                    let path = format!("{dir}/{}.html", s.name.replace('/', "_"));
                    std::fs::write(&path, chereme::format::html::write(chereme::avatar::GLB, &p.track, &page).unwrap()).unwrap();
                    let (a, b) = (r.stroke_start.0 + 0.02, r.sign_end.0 - 0.02);
                    plan.push((s.name, path, a, b));
                }
            }
        }
    }
    let front = r#"{"position":[0,1.30,1.75],"target":[0,1.27,0],"fov":34}"#;
    let side = r#"{"position":[-1.5,1.40,1.15],"target":[0,1.25,0.08],"fov":30}"#;
    let cells: Vec<String> = plan.iter().flat_map(|(n, p, a, b)| {
        let abs = std::fs::canonicalize(p).unwrap();
        let abs = abs.display().to_string();
        [(*a, front, "start"), ((a + b) / 2.0, front, "mid"), (*b, front, "end"), (*b, side, "end, side")].map(|(t, c, l)| format!(r#"{{"html":"{abs}","t":{t:.3},"camera":{c},"label":"{n} {t:.2} {l}"}}"#))
    }).collect();
    for (i, chunk) in cells.chunks(24).enumerate() {
        std::fs::write(format!("{dir}/plan{i}.json"), format!(r#"{{"out":"sheet{i}.png","columns":8,"cell":[250,260],"cells":[{}]}}"#, chunk.join(","))).unwrap();
    }
}
