#!/usr/bin/env python3
"""Holds the packages that a build brings in to the lists of deny.toml: licences, versions, origins.

What `cargo deny` checks, but for advisories, for machines that do not have it; it takes minutes to
build. `--self-test` feeds it licences of known answer.
"""

import json
import pathlib
import re
import subprocess
import sys
import tomllib

HERE = pathlib.Path(__file__).parent
REGISTRY = "registry+https://github.com/rust-lang/crates.io-index"


def cargo(*arguments):
    command = ["cargo", *arguments, "--locked", "--manifest-path", HERE.parent / "Cargo.toml"]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def allows(expression, allowed):
    """Whether an SPDX expression (also in the older form with a slash) can be met by what is allowed."""
    words = re.findall(r"[()]|[^\s()]+", expression.replace("/", " OR "))
    words.reverse()

    def either():
        met = both()
        while words and words[-1] == "OR":
            words.pop()
            met = both() or met
        return met

    def both():
        met = one()
        while words and words[-1] == "AND":
            words.pop()
            met = one() and met
        return met

    def one():
        word = words.pop()
        if word == "(":
            met = either()
            words.pop()
            return met
        if words and words[-1] == "WITH":
            words.pop()
            word += " WITH " + words.pop()
        return word in allowed

    return either()


def self_test():
    allowed = {"MIT", "Zlib", "Apache-2.0 WITH LLVM-exception"}
    cases = {
        "MIT": True, "GPL-3.0": False, "GPL-3.0 OR MIT": True, "GPL-3.0/MIT": True,
        "MIT AND GPL-3.0": False, "(GPL-3.0 OR MIT) AND Zlib": True, "MIT AND Zlib OR GPL-3.0": True,
        "Apache-2.0": False, "Apache-2.0 WITH LLVM-exception OR GPL-3.0": True,
        "GPL-3.0 AND (MIT OR Zlib)": False,
    }
    for expression, answer in cases.items():
        assert allows(expression, allowed) == answer, expression
    print(f"self-test: {len(cases)} cases")


def used():
    """Name and version of every package that is compiled into a build or at its making."""
    tree = cargo("tree", "--all-features", "-e", "normal,build", "--prefix", "none", "--format", "{p}")
    return sorted({tuple(line.split()[:2]) for line in tree.splitlines() if line})


def faults(lists):
    about = {(p["name"], "v" + p["version"]): p
             for p in json.loads(cargo("metadata", "--format-version", "1", "--all-features"))["packages"]}
    allowed = set(lists["licenses"]["allow"])
    skipped = [skip["crate"].split("@") for skip in lists["bans"]["skip"]]
    needless = {name + "@" + version for name, version in skipped}
    versions = {}
    for name, version in used():
        package = about[name, version]
        licence = package["license"] or "none"
        if not allows(licence, allowed):
            yield f"{name} {version}: licence {licence}; allowed: those in scripts/deny.toml"
        if package["source"] not in (None, REGISTRY):
            yield f"{name} {version}: from {package['source']}; allowed: crates.io"
        skips = {f"{n}@{v}" for n, v in skipped if name == n and (version[1:] + ".").startswith(v + ".")}
        needless -= skips
        versions.setdefault(name, []).extend([] if skips else [version])
    for name, several in versions.items():
        if len(several) > 1:
            yield f"{name}: {', '.join(several)} at once; allowed: one, or a reason in scripts/deny.toml"
    for skip in sorted(needless):
        yield f"{skip}: is not there any more; take it out of scripts/deny.toml"


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    found = list(faults(tomllib.loads((HERE / "deny.toml").read_text())))
    print("\n".join(found) or f"supply: {len(used())} packages, nothing to say against them")
    return sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
