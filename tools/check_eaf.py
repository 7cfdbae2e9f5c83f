#!/usr/bin/env python3
"""Check EAF files that chereme wrote: well formed, and the same tiers, values and times as in the page beside them; or how
it reads those of others.

usage: check_eaf.py [--schema EAFv3.0.xsd] [--pympi] FILE.eaf...
  chereme render BOL -o bol.html -o bol.eaf && python3 tools/check_eaf.py bol.eaf
usage: check_eaf.py --read target/debug/examples/annotations_table FILE.eaf...
  of any EAF file: what chereme reads of it against what pympi-ling does

Needs Python 3.9 alone. With --schema also lxml (PyPI), and the schema that ELAN's makers publish at
http://www.mpi.nl/tools/elan/EAFv3.0.xsd (part of ELAN, GPL 3, so it is not kept here). With --pympi also pympi-ling (PyPI),
the library that most Python scripts for ELAN stand on; it must read what we read.
"""
import argparse
import csv
import io
import json
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree


def tiers_of_file(path):
    """{tier: [(begin ms, end ms, value)]} of tiers with times, and {tier: {index of value: source}}."""
    root = ElementTree.parse(path).getroot()
    times = {slot.get("TIME_SLOT_ID"): int(slot.get("TIME_VALUE")) for slot in root.iter("TIME_SLOT")}
    tiers, sources, place = {}, {}, {}
    for tier in root.iter("TIER"):
        name = tier.get("TIER_ID")
        for annotation in tier.iter("ALIGNABLE_ANNOTATION"):
            values = tiers.setdefault(name, [])
            place[annotation.get("ANNOTATION_ID")] = (name, len(values))
            begin, end = (times[annotation.get(f"TIME_SLOT_REF{n}")] for n in (1, 2))
            values.append((begin, end, annotation.findtext("ANNOTATION_VALUE")))
        for annotation in tier.iter("REF_ANNOTATION"):
            of, index = place[annotation.get("ANNOTATION_REF")]
            sources.setdefault(of, {})[index] = annotation.findtext("ANNOTATION_VALUE")
    return tiers, sources


def tiers_of_page(path):
    """The same of a page, from the data that the viewer reads."""
    text = path.read_text(encoding="utf-8")
    data = json.loads(text.split('id="chereme-data">', 1)[1].split("</script", 1)[0])
    # Half a millisecond goes up, as in Rust.
    ms = lambda seconds: int(seconds * 1000 + 0.5)
    tiers = {t["name"]: [(ms(v["start"]), ms(v["end"]), v["label"]) for v in t["values"]] for t in data["tiers"]}
    sources = {t["name"]: {i: v["source"] for i, v in enumerate(t["values"])} for t in data["tiers"]}
    return tiers, sources


def check(path, schema, pympi):
    """The faults of a file, and how many values it has. `schema` gives those that the schema finds."""
    faults = []
    tiers, sources = tiers_of_file(path)
    page = path.with_suffix(".html")
    if page.exists() and tiers_of_page(page) != (tiers, sources):
        faults.append(f"not the tiers of {page}")
    if schema is not None:
        faults += schema(path)
    if pympi is not None:
        read = pympi.Elan.Eaf(str(path))
        for name, values in tiers.items():
            theirs = sorted(tuple(a[:3]) for a in read.get_annotation_data_for_tier(name))
            if theirs != sorted(values):
                faults.append(f"pympi reads {name} as {theirs}")
        for name in tiers:
            parent = read.get_parameters_for_tier(name).get("PARENT_REF")
            inside = lambda v: any(b <= v[0] and v[1] <= e for b, e, _ in tiers[parent])
            if parent and not all(inside(v) for v in tiers[name]):
                faults.append(f"{name} leaves {parent}")
    return faults, sum(map(len, tiers.values()))


def check_reading(path, example, pympi):
    """The same of any file as chereme reads it: by the annotations' ids, their tiers, times and texts as pympi has them.

    pympi leaves out the times of slots without a value; they are compared where it has them. Annotations that refer to
    others have the time of the one with time slots, or lie within it where there is a subdivision between.
    """
    run = subprocess.run([example, path], capture_output=True, text=True)
    if run.returncode != 0:
        return [run.stderr.strip()], 0
    ms = lambda text: round(float(text) * 1000)
    rows = csv.DictReader(io.StringIO(run.stdout, newline=""), delimiter="\t")
    ours = {row["source"]: (row["tier"], ms(row["start"]), ms(row["end"]), row["label"]) for row in rows}
    count = len(ours)
    read = pympi.Elan.Eaf(str(path))
    aligned, refers, divides = {}, {}, set()
    for name, (with_times, with_references, attributes, _) in read.tiers.items():
        if read.linguistic_types[attributes["LINGUISTIC_TYPE_REF"]].get("CONSTRAINTS") == "Symbolic_Subdivision":
            divides |= with_references.keys()
        aligned |= {i: (name, read.timeslots[a[0]], read.timeslots[a[1]], a[2]) for i, a in with_times.items()}
        refers |= {i: (name, a[0], a[1]) for i, a in with_references.items()}
    faults, timed = [], 0
    for i in [*aligned, *refers]:
        top, divided = i, False
        while top in refers:
            divided |= top in divides
            top = refers[top][1]
        name, text = (aligned[i][0], aligned[i][3]) if i in aligned else (refers[i][0], refers[i][2])
        begin, end = aligned[top][1:3]
        tier, start, stop, label = ours.pop(i, (None, 0, 0, None))
        if (tier, label) != (name, text or ""):
            faults.append(f"{i}: {tier} {label!r}, pympi {name} {text!r}")
        for own, theirs, side in ((start, begin, 1), (stop, end, -1)):
            timed += theirs is not None
            if theirs is not None and (own - theirs) * side < 0 or (not divided and theirs not in (None, own)):
                faults.append(f"{i}: at {own} ms, pympi {theirs}")
    print(f"{path.name}: {timed} of {2 * count} times compared, {len(refers)} annotations refer to others")
    return faults[:20] + [f"{i}: pympi has no such annotation" for i in ours], count


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("files", nargs="+", type=pathlib.Path)
    options.add_argument("--schema", type=pathlib.Path)
    options.add_argument("--pympi", action="store_true")
    options.add_argument("--read", metavar="EXAMPLE", help="the example annotations_table, built")
    given = options.parse_args()
    schema = pympi = None
    if given.schema:
        from lxml import etree

        rules = etree.XMLSchema(file=str(given.schema))

        def schema(path):
            valid = rules.validate(etree.parse(str(path)))
            return [] if valid else [f"line {e.line}: {e.message}" for e in rules.error_log]

    if given.pympi or given.read:
        import pympi
    failed = False
    for path in given.files:
        try:
            faults, count = check_reading(path, given.read, pympi) if given.read else check(path, schema, pympi)
        except ElementTree.ParseError as error:
            faults, count = [f"not well formed: {error}"], 0
        print(f"{path}: {count} values, " + ("; ".join(faults) or "no faults"))
        failed |= bool(faults) or count == 0
    sys.exit(failed)


main()
