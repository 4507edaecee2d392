#!/usr/bin/env python3
"""Opens a page of HTML from disk in headless Chromium, wide and narrow, light and dark, and prints what is there as JSON:
a list with "width", "scheme", "errors" (of the console and of scripts), "requests" (beyond the page itself), "images" and
"loaded_images", "overflow_px" (beyond the width), "ink" and "paper" (colours), "drawn_plots" and "tip" (what pointing at
the first outline of the plan tells). Exit code 77 where there is no Chromium.

    look_at_page.py PAGE [--screenshots DIR [--only SELECTOR]]
"""
import argparse
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

WIDTHS_PX = (1280, 400)
SCHEMES = ("light", "dark")

WHAT_IS_THERE = """
(async () => {
  for (const details of document.querySelectorAll('details')) details.open = true;
  for (const image of document.images) image.loading = 'eager';
  await Promise.all([...document.images].map(image => image.decode().catch(() => null)));
  const plan = [...document.querySelectorAll('svg image')];
  const decoded = await Promise.all(plan.map(image => {
    const copy = new Image();
    copy.src = image.getAttribute('href');
    return copy.decode().then(() => copy.naturalWidth, () => 0);
  }));
  const style = getComputedStyle(document.body);
  const drawn = canvas => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.some(v => v !== 0);
  const thing = document.querySelector('#plan polygon');
  const tip = document.getElementById('tip');
  let told = '';
  if (thing) {
    thing.dispatchEvent(new PointerEvent('pointermove', {clientX: 10, clientY: 10}));
    told = tip.hidden ? '' : tip.textContent;
    tip.hidden = true;
  }
  return {
    images: document.images.length + plan.length,
    loaded_images: [...document.images].filter(image => image.naturalWidth > 0).length + decoded.filter(w => w > 0).length,
    overflow_px: document.documentElement.scrollWidth - document.documentElement.clientWidth,
    inner_width: window.innerWidth,
    height_px: document.documentElement.scrollHeight,
    ink: style.color, paper: style.backgroundColor,
    drawn_plots: [...document.querySelectorAll('.plot')].filter(plot => [...plot.querySelectorAll('canvas')].some(drawn)).length,
    tip: told
  };
})()
"""


class Browser:
    """Chromium, spoken to through a pipe."""

    def __init__(self, program, profile):
        to_browser, self.to_browser = os.pipe()
        self.from_browser, from_browser = os.pipe()

        def place_pipes():  # Chromium reads from 3 and writes to 4
            kept = [os.dup(to_browser), os.dup(from_browser)]
            high = [os.dup(fd) for fd in kept]
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        command = [program, "--headless=new", "--disable-gpu", "--no-first-run", "--disable-extensions", "--hide-scrollbars",
                   "--disable-background-networking", "--disable-component-update", "--remote-debugging-pipe",
                   f"--user-data-dir={profile}", "--disable-dev-shm-usage"]
        if os.geteuid() == 0:
            command.append("--no-sandbox")  # which root cannot have
        self.process = subprocess.Popen(command + ["about:blank"], preexec_fn=place_pipes, close_fds=False,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.pending = b""
        self.events = []
        self.number = 0
        self.session = None
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]

    def receive(self):
        while b"\0" not in self.pending:
            more = os.read(self.from_browser, 1 << 20)
            if not more:
                raise RuntimeError("Chromium ended")
            self.pending += more
        message, self.pending = self.pending.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def wait_for(self, method):
        while not any(event.get("method") == method for event in self.events):
            self.events.append(self.receive())

    def take(self, method):
        return [event["params"] for event in self.events if event.get("method") == method]

    def evaluate(self, script):
        answer = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"])
        return answer["result"].get("value")

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


def errors_of(browser):
    errors = [e["exceptionDetails"].get("exception", {}).get("description") or e["exceptionDetails"]["text"]
              for e in browser.take("Runtime.exceptionThrown")]
    errors += [" ".join(str(a.get("value", a.get("description"))) for a in e["args"])
               for e in browser.take("Runtime.consoleAPICalled") if e["type"] in ("error", "warning", "assert")]
    errors += [e["entry"]["text"] for e in browser.take("Log.entryAdded") if e["entry"]["level"] in ("error", "warning")]
    return errors


def look(browser, page, width_px, scheme):
    browser.call("Emulation.setDeviceMetricsOverride", width=width_px, height=900, deviceScaleFactor=1,
                 mobile=width_px < 600)
    browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
    browser.events.clear()
    address = page.resolve().as_uri()
    browser.call("Page.navigate", url=address)
    browser.wait_for("Page.loadEventFired")
    found = browser.evaluate(WHAT_IS_THERE)
    requests = [r["request"]["url"] for r in browser.take("Network.requestWillBeSent")]
    found.update(width=width_px, scheme=scheme, errors=errors_of(browser),
                 requests=[url[:200] for url in requests if url != address and not url.startswith("data:")])
    return found


def screenshot(browser, found, selector, file):
    browser.evaluate("for (const details of document.querySelectorAll('details')) details.open = false;")
    box = browser.evaluate(f"(() => {{ const b = document.querySelector({json.dumps(selector)}).getBoundingClientRect();"
                           "return [b.x + scrollX, b.y + scrollY, b.width, b.height]; })()")
    clip = {"x": box[0], "y": box[1], "width": box[2], "height": box[3], "scale": 1}
    picture = browser.call("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip)
    file.write_bytes(base64.b64decode(picture["data"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path)
    parser.add_argument("--only", default="html", metavar="SELECTOR", help="of the page, in screenshots")
    arguments = parser.parse_args()
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if not program:
        print("pages are looked at with Chromium (in Debian: chromium), which is not installed", file=sys.stderr)
        return 77
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(program, profile)
        try:
            for domain in ("Page", "Runtime", "Log", "Network"):
                browser.call(domain + ".enable")
            looks = []
            for width_px in WIDTHS_PX:
                for scheme in SCHEMES:
                    looks.append(look(browser, arguments.page, width_px, scheme))
                    if arguments.screenshots:
                        arguments.screenshots.mkdir(parents=True, exist_ok=True)
                        screenshot(browser, looks[-1], arguments.only,
                                   arguments.screenshots / f"{width_px}_{scheme}.png")
        finally:
            browser.close()
    print(json.dumps(looks, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
