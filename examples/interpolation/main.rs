//! Peak speeds of a pointing and of DODO under the interpolations that Naert et al. 2021 compare (figures 6 and 10) and minimum jerk,
//! beside the theory, as a Markdown table: `cargo run --release --example interpolation`.

mod measure;

fn main() {
    println!(
        "| gesture | interpolation | peak speed (m/s) | at (share of the way's time) | peak/mean of the leading joint | theory |"
    );
    println!("|---|---|---|---|---|---|");
    for row in measure::measure() {
        let name = row.easing.to_string().replace("linear", "slerp");
        let theory = row.theory();
        println!("| {} | {name} | {:.2} | {:.2} | {:.3} | {theory:.3} |", row.gesture, row.peak, row.at, row.ratio);
    }
}
