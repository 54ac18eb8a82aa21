"""`riffle watch`: what it serves to whom, the states of a run, and its page in a browser."""
import http.client
import json
import os
import shutil
import signal
import socket
import subprocess
from pathlib import Path

from riffle_cli import CASE, SMALL, SOURCE, CommandLineTest, main, start, until, wait_for

OFTEN = ["--set", "output.checkpoint_interval=0.2"]


class Watch(CommandLineTest):
    def watch(self, folder, *options):
        """Start watching; the port."""
        process = start("watch", folder, *(options or ("--port", "0")))
        self.addCleanup(self.end, process)
        url = process.stdout.readline().strip()
        self.assertRegex(url, r"^http://[^/]+:\d+/$", process.stderr.read() if process.poll() is not None else "")
        self.process, self.url, self.port = process, url, int(url.rstrip("/").rsplit(":", 1)[1])
        return self.port

    def end(self, process):
        if process.poll() is None:
            process.kill()
        process.communicate()

    def ask(self, path, method="GET", host=None, headers=(), body=None):
        """The answer to a request: status, headers, text."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        all_headers = {"Host": host, **dict(headers)} if host is not None else dict(headers)
        connection.request(method, path, body=body, headers=all_headers)
        answer = connection.getresponse()
        text = answer.read().decode(errors="replace")
        connection.close()
        return answer.status, answer.headers, text

    def status(self):
        return json.loads(self.ask("/status.json")[2])

    def begin(self, folder, seconds, *options):
        process = start("run", CASE, "-o", folder, "-j", 1, "-q", *SMALL, *until(seconds), *OFTEN, *options)
        self.addCleanup(self.end, process)
        return process

    def test_page_and_data_of_a_finished_run(self):
        self.watch(self.run_small("run", 1))
        status, headers, page = self.ask("/")
        self.assertEqual((status, headers["Content-Type"]), (200, "text/html; charset=utf-8"))
        for path in ("/report.css", "/watch.css", "/plotly.js", "/shared.js", "/field.js", "/watch.js"):
            self.assertIn(path, page)
            status, headers, text = self.ask(path)
            self.assertEqual(status, 200, path)
            self.assertEqual(len(text.encode()), int(headers["Content-Length"]))
            self.assertEqual(self.ask(path, headers={"If-None-Match": headers["ETag"]})[::2], (304, ""))
        status, headers, text = self.ask("/data.json")
        data = json.loads(text)
        self.assertGreater(data["progress"]["steps"], 1000)
        self.assertAlmostEqual(data["progress"]["time"], 1, delta=0.001)
        history = next(figure for figure in data["analyses"]["analyses"][0]["figures"] if figure["key"] == "velocity_history")
        self.assertAlmostEqual(history["curves"][0]["x"][-1], 1, delta=0.02)
        self.assertGreaterEqual(len(data["report"]["diagnostics"]), 5)
        self.assertEqual(self.status()["state"], "finished")
        # Unchanged results are not sent again.
        self.assertEqual(self.ask("/data.json", headers={"If-None-Match": headers["ETag"]})[::2], (304, ""))

    def test_nothing_but_its_own_paths_and_get(self):
        self.watch(self.run_small("run", 0.1))
        for path in ("/results.h5", "/../run.log", "/%2e%2e/run.log", "//", "/index.html", "/data.json/x",
                     "/etc/passwd", "/?file=/etc/passwd/../x%00"):
            status, _, text = self.ask(path)
            self.assertIn(status, (404,) if "?" not in path else (200,), path)
            self.assertNotIn("root:", text)
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "PATCH"):
            status, headers, _ = self.ask("/data.json", method, body=b"x" * 100)
            self.assertEqual((status, headers["Allow"]), (405, "GET"), method)
        for path in ("/", "/data.json", "/status.json", "/no-such-page"):
            headers = self.ask(path)[1]
            self.assertIn("default-src 'none'", headers["Content-Security-Policy"], path)
            self.assertNotIn("unsafe-eval", headers["Content-Security-Policy"])
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertIsNone(headers["Access-Control-Allow-Origin"])

    def test_refuses_names_that_are_not_its_own(self):
        self.watch(self.run_small("run", 0.1))
        for host in (f"evil.example:{self.port}", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example",
                     "192.0.2.1", "", "localhost:", "[::1", "localhost@evil.example"):
            with self.subTest(host=host):
                status, _, text = self.ask("/data.json", host=host)
                self.assertEqual(status, 403)
                self.assertNotIn("progress", text)
        for host in (f"127.0.0.1:{self.port}", "localhost", "LOCALHOST:9000", f"[::1]:{self.port}"):
            self.assertEqual(self.ask("/data.json", host=host)[0], 200, host)
        with socket.create_connection(("127.0.0.1", self.port), timeout=60) as raw:
            raw.sendall(b"GET /data.json HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n")
            self.assertIn(b"403", raw.recv(100))

    def test_listens_on_the_loopback_address_only(self):
        self.watch(self.folder / "run")
        listening = set()
        for table in ("/proc/net/tcp", "/proc/net/tcp6"):
            for line in Path(table).read_text().splitlines()[1:] if Path(table).exists() else ():
                fields = line.split()
                address, port = fields[1].rsplit(":", 1)
                if fields[3] == "0A" and int(port, 16) == self.port:
                    listening.add(address)
        self.assertEqual(listening, {"0100007F"})  # 127.0.0.1 in the byte order of the machine

    def test_a_request_that_is_too_long_is_refused_before_it_ends(self):
        self.watch(self.run_small("run", 0.1))
        for start_of, status in ((b"GET /" + b"x" * 20000, b"414"), (b"GET / HTTP/1.1\r\nX: " + b"x" * 20000, b"431"),
                                 (b"\x16\x03\x01 no HTTP\r\n\r\n", b"400")):
            with socket.create_connection(("127.0.0.1", self.port), timeout=60) as raw:
                raw.sendall(start_of)
                self.assertIn(b"HTTP/1.1 " + status, raw.recv(200))

    def test_slow_connections_keep_nobody_waiting(self):
        self.watch(self.run_small("run", 0.1))
        slow = [socket.create_connection(("127.0.0.1", self.port), timeout=60) for _ in range(200)]
        self.addCleanup(lambda: [connection.close() for connection in slow])
        for connection in slow[-50:]:
            connection.sendall(b"GET /data.json HTT")
        self.assertEqual(self.ask("/")[0], 200)
        self.assertEqual(self.status()["state"], "finished")
        # They were answered while the newest of the slow ones were still waited for.
        slow[-1].setblocking(False)  # with a time-out recv() would wait for it
        with self.assertRaises(BlockingIOError):
            slow[-1].recv(1)
        slow[-1].settimeout(60)
        for connection in slow:
            self.assertEqual(connection.recv(1), b"", "a connection without a request stays open")

    def test_other_addresses_only_when_asked_and_with_a_warning(self):
        self.watch(self.folder / "run", "--port", "0", "--listen", "0.0.0.0")
        self.assertEqual(self.ask("/status.json", host="192.0.2.1")[0], 200)
        self.assertEqual(self.ask("/status.json", host="evil.example")[0], 403)
        self.process.send_signal(signal.SIGTERM)
        _, messages = self.process.communicate(timeout=60)
        self.assertEqual(self.process.returncode, 0)
        self.assertIn("warning: --listen 0.0.0.0", messages)
        self.assertNotIn("--listen", self.warnings_of("127.0.0.1"))

    def warnings_of(self, address):
        self.watch(self.folder / "run", "--port", "0", "--listen", address)
        self.process.send_signal(signal.SIGINT)
        return self.process.communicate(timeout=60)[1]

    def test_a_port_that_is_taken(self):
        port = self.watch(self.folder / "run")
        self.fail_with(2, "watch", self.folder / "run", "--port", port, says=[f"--port {port}", "another port"])
        self.fail_with(2, "watch", self.folder / "run", "--port", "70000", says=["70000"])
        self.fail_with(2, "watch", self.folder / "run", "--listen", "192.0.2.1", says=["--listen 192.0.2.1", "127.0.0.1"])
        self.fail_with(2, "watch", self.folder / "run", "--listen", "", says=["--listen"])
        # Without --port the next that is free is taken.
        ports = {self.watch(self.folder / "run", "--listen", "127.0.0.1") for _ in range(3)}
        self.assertEqual(len(ports), 3)

    def test_interrupt_ends_it_with_success(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            self.watch(self.folder / "run")
            self.process.send_signal(number)
            _, messages = self.process.communicate(timeout=60)
            self.assertEqual(self.process.returncode, 0, messages)
            with self.assertRaises(OSError):
                socket.create_connection(("127.0.0.1", self.port), timeout=60)

    def test_states_of_a_run(self):
        folder = self.folder / "run"
        self.watch(folder)
        self.assertEqual(self.status()["state"], "waiting")
        self.assertEqual(self.ask("/data.json")[2], "{}")
        run = self.begin(folder, 10000)
        wait_for(lambda: self.status()["state"] == "running", "the run")
        self.assertIn(f"Process {run.pid}", self.status()["reason"])
        wait_for((folder / "checkpoint.h5").exists, "the first checkpoint")
        run.kill()
        run.communicate()
        self.assertEqual(self.status()["state"], "lost")
        resumed = start("resume", folder, "-j", 1, "-q", *until(10000))
        self.addCleanup(self.end, resumed)
        wait_for(lambda: self.status()["state"] == "running", "the resumed run")
        resumed.send_signal(signal.SIGINT)
        resumed.communicate(timeout=60)
        self.assertEqual(self.status()["state"], "stopped")
        reached = json.loads(self.ask("/data.json")[2])["progress"]["time"]
        self.succeed("resume", folder, "-j", 1, "-q", *until(reached + 0.1))
        self.assertEqual(self.status()["state"], "finished")

    def test_a_file_that_cannot_be_read_shows_the_reason(self):
        folder = self.run_small("run", 0.1)
        results = folder / "results.h5"
        self.watch(folder)
        first = self.ask("/data.json")
        whole = results.read_bytes()
        for damaged, words in ((whole[:1000], "truncated"), (b"no HDF5 at all", "not an HDF5 file of results")):
            results.write_bytes(damaged)
            wait_for(lambda: words in self.ask("/data.json")[2], words)
            self.assertEqual(list(json.loads(self.ask("/data.json")[2])), ["error"])
        results.write_bytes(whole)
        wait_for(lambda: "progress" in self.ask("/data.json")[2], "the whole file")
        self.assertNotEqual(self.ask("/data.json")[1]["ETag"], first[1]["ETag"])

    def test_a_copy_under_another_name_has_no_log(self):
        folder = self.run_small("run", 0.1)
        (folder / "run.log").write_text("2026-11-21 10:09:31 info    resumed at t = 0 s\n")
        shutil.copy(folder / "results.h5", folder / "kept.h5")
        self.watch(folder / "kept.h5")
        self.assertEqual((self.status()["state"], self.status()["reason"]),
                         ("finished", "The results file is marked as complete."))

    def test_page_in_a_browser(self):
        self.need_browser()
        folder = self.folder / "run"
        self.watch(folder)
        screenshots = [os.environ["RIFFLE_SCREENSHOTS"]] if "RIFFLE_SCREENSHOTS" in os.environ else []
        browser = subprocess.Popen(["node", SOURCE / "tests/end_to_end/watch_browser.mjs", self.url, *screenshots],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.end, browser)

        def shows(word):
            line = browser.stdout.readline().strip()
            if line != word:
                self.fail(f"the page showed {line!r} instead of {word!r}: {browser.communicate(timeout=60)[1]}")

        shows("waiting")
        run = self.begin(folder, 10000)
        shows("advanced")
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(timeout=60), 130)
        shows("stopped")
        reached = json.loads(self.ask("/data.json")[2])["progress"]["time"]
        self.succeed("resume", folder, "-q", "-j", 1, *until(reached + 1))
        shows("finished")
        shows("looked")
        self.process.send_signal(signal.SIGINT)
        self.process.communicate(timeout=60)
        shows("alone")
        browser.communicate(timeout=60)
        self.assertEqual(browser.returncode, 0)


if __name__ == "__main__":
    main()
