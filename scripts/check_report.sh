#!/usr/bin/env bash
# Opens a report from disk in Chromium at several widths, light and dark, and checks that it shows
# everything and fetches nothing. On Debian it installs Chromium and Python if they are absent.
#
#   scripts/check_report.sh REPORT.html [--pictures DIR]   checks a report; keeps pictures to look at
#   scripts/check_report.sh REPORT.html --self-test        feeds it spoilt copies that it must reject
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

if [ $# -lt 1 ] || [ ! -f "$1" ]; then
    echo "usage: check_report.sh REPORT.html [--pictures DIR | --self-test]; REPORT.html must be a file" >&2
    exit 2
fi

need() { # command package
    command -v "$1" >/dev/null && return
    if command -v apt-get >/dev/null && { apt-get update -qq && apt-get install -y -qq "$2"; } >/dev/null 2>&1; then
        return
    fi
    echo "$1 is missing; install $2" >&2
    exit 2
}
need chromium chromium
need python3 python3

exec python3 "$here/check_report.py" "$@"
