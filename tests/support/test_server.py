#!/usr/bin/env python3
"""A web server on 127.0.0.1 that serves one folder until its standard input ends.

usage: test_server.py FOLDER STATE

Writes its port to STATE/port once it listens, and the Range header of every request ("-" without) to STATE/requests.
/NAME is served whole or from the byte asked for; /norange/NAME always whole; /cut/NAME breaks off in the middle.
"""

import http.server
import os
import re
import sys
import threading

FOLDER, STATE = sys.argv[1:]


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        asked = self.headers.get("Range")
        with open(os.path.join(STATE, "requests"), "a", encoding="utf-8") as log:
            log.write((asked or "-") + "\n")
        *mode, name = self.path.strip("/").split("/")
        path = os.path.join(FOLDER, name)
        if not os.path.isfile(path):
            self.send_error(404)
            return
        with open(path, "rb") as file:
            content = file.read()
        begin = int(re.match(r"bytes=(\d+)-", asked)[1]) if asked and mode != ["norange"] else None
        if begin is not None and begin >= len(content):
            self.send_error(416)
            return
        self.answer(content, begin, cut=mode == ["cut"])

    def answer(self, content, begin, cut):
        rest = content[begin or 0:]
        self.send_response(200 if begin is None else 206)
        self.send_header("Content-Length", str(len(rest)))
        if begin is not None:
            self.send_header("Content-Range", f"bytes {begin}-{len(content) - 1}/{len(content)}")
        self.end_headers()
        self.wfile.write(rest[: len(rest) // 2] if cut else rest)

    def log_message(self, *_):
        pass


server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
threading.Thread(target=server.serve_forever, daemon=True).start()
with open(os.path.join(STATE, "port.new"), "w", encoding="utf-8") as port:
    port.write(str(server.server_address[1]))
os.rename(os.path.join(STATE, "port.new"), os.path.join(STATE, "port"))
sys.stdin.read()
