#!/usr/bin/env python3
"""The manual as a site: it is built without a warning, no link of it is broken, and nothing is loaded from elsewhere.

Usage: manual_site_test.py; needs mkdocs.
"""
import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOADED = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("object", "data"), ("source", "src")}
IN_STYLES = re.compile(r"(?:url\(|@import)\s*[\"']?(?:https?:)?//")


class Reader(html.parser.HTMLParser):
    """What a page loads, where it leads, and the places in it."""

    def __init__(self, text):
        super().__init__()
        self.loaded, self.links, self.places = [], [], {""}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if (tag, name) in LOADED:
                self.loaded.append(value)
            elif (tag, name) == ("a", "href"):
                self.links.append(value)
            elif name == "id":
                self.places.add(value)


def is_elsewhere(address):
    return bool(urllib.parse.urlsplit(address).netloc) or address.startswith("http")


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name)
        done = subprocess.run(["mkdocs", "build", "--strict", "--site-dir", cls.root], cwd=ROOT, check=False,
                              capture_output=True, text=True)
        cls.said = done.stdout + done.stderr
        cls.exit_code = done.returncode
        cls.pages = {file: Reader(file.read_text(encoding="utf-8")) for file in sorted(cls.root.rglob("*.html"))
                     if file.name != "404.html"}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_it_is_built_without_a_warning(self):
        self.assertEqual(self.exit_code, 0, self.said)
        self.assertNotIn("not included in the \"nav\"", self.said)
        self.assertGreaterEqual(len(self.pages), len(list((ROOT / "docs").rglob("*.md"))))

    def test_nothing_is_loaded_from_elsewhere(self):
        for file, page in self.pages.items():
            self.assertTrue(page.loaded, file)
            self.assertEqual([address for address in page.loaded if is_elsewhere(address)], [], file)
        styles = sorted(self.root.rglob("*.css"))
        self.assertTrue(styles)
        for file in styles:
            self.assertIsNone(IN_STYLES.search(file.read_text(encoding="utf-8")), file)

    def test_each_link_and_each_file_is_there(self):
        for file, page in self.pages.items():
            for address in page.loaded + page.links:
                if is_elsewhere(address) or address.startswith("mailto:"):
                    continue
                parts = urllib.parse.urlsplit(address)
                path = urllib.parse.unquote(parts.path)
                target = (file.parent / path).resolve() if path else file
                with self.subTest(page=file.name, link=address):
                    self.assertTrue(target.is_file(), "no such file")
                    if parts.fragment and target in self.pages:
                        self.assertIn(urllib.parse.unquote(parts.fragment), self.pages[target].places)


if __name__ == "__main__":
    if not shutil.which("mkdocs"):
        print("mkdocs is not installed: the site is not tried")
        sys.exit(77)
    unittest.main()
