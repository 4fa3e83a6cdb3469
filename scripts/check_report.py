"""Checks a report in Chromium over the DevTools protocol; run by check_report.sh.

Nothing but the standard library: the browser is spoken to through a pipe, one JSON text a message.
"""

import base64
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

WIDTHS = (360, 800, 1600)
SCHEMES = ("light", "dark")
HEIGHT = 900

# What the page itself can tell; returns a list of complaints and what was counted.
PROBE = (pathlib.Path(__file__).with_suffix(".js")).read_text()


class Browser:
    """A headless browser and one page of it."""

    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="check_report.")
        ours_in, theirs_out = os.pipe()
        theirs_in, ours_out = os.pipe()

        def numbered():
            # The browser reads from 3 and writes to 4; both may be in the way of each other.
            read, write = os.dup(theirs_in), os.dup(theirs_out)
            high = [os.dup(read), os.dup(write)]
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
             "--no-first-run", "--disable-background-networking", "--disable-extensions",
             "--host-resolver-rules=MAP * ~NOTFOUND", "--remote-debugging-pipe",
             f"--user-data-dir={self.folder}", "about:blank"],
            preexec_fn=numbered, close_fds=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(theirs_in)
        os.close(theirs_out)
        self.read, self.write = os.fdopen(ours_in, "rb", 0), os.fdopen(ours_out, "wb", 0)
        self.rest, self.number, self.events, self.session = b"", 0, [], None
        pages = self.ask("Target.getTargets")["targetInfos"]
        page = next(target for target in pages if target["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")

    def message(self):
        while b"\0" not in self.rest:
            part = os.read(self.read.fileno(), 1 << 20)
            if not part:
                raise SystemExit("the browser ended")
            self.rest += part
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def ask(self, method, **arguments):
        self.number += 1
        request = {"id": self.number, "method": method, "params": arguments}
        if self.session:
            request["sessionId"] = self.session
        self.write.write(json.dumps(request).encode() + b"\0")
        while True:
            message = self.message()
            if message.get("id") == self.number:
                if "error" in message:
                    raise SystemExit(f"{method}: {message['error']}")
                return message["result"]
            self.events.append(message)

    def wait(self, method):
        while not any(event.get("method") == method for event in self.events):
            self.events.append(self.message())

    def open(self, address, width, scheme):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=HEIGHT,
                 deviceScaleFactor=1, mobile=width < 600)
        self.ask("Emulation.setEmulatedMedia",
                 features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.events.clear()
        self.ask("Page.navigate", url=address)
        self.wait("Page.loadEventFired")

    def evaluate(self, script):
        answer = self.ask("Runtime.evaluate", expression=script, returnByValue=True)
        if "exceptionDetails" in answer:
            raise SystemExit(f"probe: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def end(self):
        self.process.kill()
        self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


def heard(events, address):
    """Requests and messages that there must not be."""
    for event in events:
        method, about = event.get("method"), event.get("params", {})
        if method == "Network.requestWillBeSent":
            url = about["request"]["url"]
            if url != address and not url.startswith("data:"):
                yield f"request: {url}"
        elif method in ("Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded"):
            yield f"console: {json.dumps(about)[:200]}"


def beside(report, seen):
    """What the files beside the report say must be in it."""
    claims = report.with_name("claims.csv")
    if claims.is_file():
        with claims.open(newline="") as file:
            expected = sum(1 for _ in csv.DictReader(file))
        if seen["verdicts"] < expected:
            yield f"{seen['verdicts']} verdicts in the page, {expected} in claims.csv"
    for link in seen["files"]:
        if not (report.parent / link).is_file():
            yield f"link to a file that is not there: {link}"


def check(report, widths, schemes, pictures=None):
    """All complaints about a report."""
    complaints, seen = [], None
    browser = Browser()
    address = report.resolve().as_uri()
    try:
        for width in widths:
            for scheme in schemes:
                browser.open(address, width, scheme)
                seen = browser.evaluate(PROBE)
                found = list(heard(browser.events, address)) + seen["complaints"]
                complaints += [f"{width} px, {scheme}: {complaint}" for complaint in found]
                if pictures:
                    keep(browser, pictures, width, scheme)
    finally:
        browser.end()
    complaints += beside(report, seen)
    size = report.stat().st_size
    if size > 5_000_000:
        complaints.append(f"{size} bytes; allowed: 5 MB")
    return complaints, seen


def keep(browser, folder, width, scheme):
    """Pictures of the top and of every tenth figure, to be looked at."""
    folder.mkdir(parents=True, exist_ok=True)
    places = browser.evaluate("""[['top', document.querySelector('header')],
        ['answers', document.querySelector('#answers')], ['claims', document.querySelector('#claims')],
        ...[...document.querySelectorAll('figure')].filter((f, n, all) => n % 10 == 3 || n > all.length - 4).map(f => [f.id, f])].filter(p => p[1]).map(p => {
            const box = p[1].getBoundingClientRect();
            return [p[0], box.top + scrollY, box.height]; })""")
    for name, top, height in places:
        browser.ask("Emulation.setDeviceMetricsOverride", width=width, deviceScaleFactor=1,
                    mobile=width < 600, height=max(HEIGHT, min(int(height) + 20, 2000)))
        browser.evaluate(f"scrollTo(0, {max(top - 10, 0)})")
        shot = browser.ask("Page.captureScreenshot", format="png")
        (folder / f"{name}-{width}-{scheme}.png").write_bytes(base64.b64decode(shot["data"]))


def self_test(report):
    """Each spoilt copy must be rejected, and for its own reason."""
    text = report.read_text()
    spoilt = {
        "console:": text.replace("</body>", "<script>console.log('x')</script></body>"),
        "script": text.replace("</body>", "<script></script></body>"),
        "request:": text.replace("</body>", "<img alt='' src='http://example.invalid/x.png'></body>"),
        "wider": text.replace("</body>", "<div style='width:3000px'>x</div></body>"),
        "twice": text.replace("</body>", "<p id='answers'></p></body>"),
        "no size": text.replace("<svg ", "<svg style='display:none' ", 1),
        "over each other": text.replace("</svg>", "<text x='40' y='40' font-size='20'>over</text>"
                                        "<text x='44' y='42' font-size='20'>under</text></svg>", 1),
        "no title": text.replace("<title id=", "<g id=", 1).replace("</title>\n<desc", "</g>\n<desc", 1),
        "leads nowhere": text.replace('href="#answers"', 'href="#nothing"', 1),
        "verdicts in the page": text.replace('<td class="verdict', '<td class="other'),
        "not there": text.replace('/rows.csv"', '/no.csv"', 1),
    }
    failed = 0
    for reason, page in spoilt.items():
        copy = report.with_name(f".spoilt.{os.getpid()}.html")
        copy.write_text(page)
        try:
            complaints, _ = check(copy, (800,), ("light",))
        finally:
            copy.unlink()
        if not any(reason in complaint for complaint in complaints):
            print(f"self-test: a copy spoilt for '{reason}' was not rejected: {complaints[:3]}")
            failed += 1
    print(f"self-test: {len(spoilt) - failed} of {len(spoilt)} spoilt copies rejected")
    return failed


def main():
    report = pathlib.Path(sys.argv[1])
    if sys.argv[2:3] == ["--self-test"]:
        raise SystemExit(1 if self_test(report) else 0)
    pictures = pathlib.Path(sys.argv[3]) if sys.argv[2:3] == ["--pictures"] else None
    complaints, seen = check(report, WIDTHS, SCHEMES, pictures)
    for complaint in complaints[:40]:
        print(complaint)
    if complaints:
        raise SystemExit(f"{len(complaints)} complaints about {report}")
    print(f"{report}: {report.stat().st_size} bytes, {seen['figures']} figures, {seen['tables']} tables, "
          f"{seen['verdicts']} verdicts; nothing fetched, nothing cut off, at {len(WIDTHS)} widths, light and dark")


if __name__ == "__main__":
    main()
