# SPDX-License-Identifier: MIT
"""links.py FOLDER: checks the links of a site without a network. Each file and anchor that a page names is there, no
address is of one machine alone, and index.html leads to every page of the manual."""
import html.parser
import pathlib
import re
import sys
import urllib.parse


class Reader(html.parser.HTMLParser):
    """The names that a page defines and the addresses that it uses."""

    def __init__(self, text):
        super().__init__()
        self.names, self.addresses = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.names.update(given[key] for key in ("id", "name") if given.get(key))
        self.addresses += [given[key] for key in ("href", "src", "data") if given.get(key) is not None]


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    pages = {path: Reader(path.read_text(encoding="utf-8")) for path in sorted(folder.rglob("*.html"))}
    failures, links, leads = [], 0, {path: set() for path in pages}
    for path, page in pages.items():
        for address in page.addresses:
            parts = urllib.parse.urlsplit(address)
            if parts.scheme in ("http", "https", "mailto") and parts.netloc not in ("localhost", "127.0.0.1"):
                continue
            links += 1
            name = urllib.parse.unquote(parts.path)
            target = (path.parent / name).resolve() if name else path
            problem = ""
            if parts.scheme == "javascript" and path.is_relative_to(folder / "reference"):
                continue  # doxygen folds lists by it
            if parts.scheme or name.startswith("/"):
                problem = "is of one machine alone"
            elif not target.is_relative_to(folder) or not target.is_file():
                problem = "is not there"
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].names:
                problem = "has no such anchor"
                # doxygen links members of a struct without a name, and writes no anchor for them.
                if path.is_relative_to(folder / "reference") and re.fullmatch("a[0-9a-f]{32}", parts.fragment):
                    continue
            if problem:
                failures.append(f"{path.relative_to(folder)}: {address} {problem}")
            leads[path].add(target)
    found, open_pages = set(), [folder / "index.html"]
    while open_pages:
        page = open_pages.pop()
        if page in leads and page not in found:
            found.add(page)
            open_pages += leads[page]
    for path in sorted(pages.keys() - found):
        if not path.is_relative_to(folder / "reference"):
            failures.append(f"{path.relative_to(folder)}: no page leads there")
    print("\n".join(failures + [f"{len(pages)} pages, {links} links, {len(failures)} broken"]))
    return 1 if failures or links < 500 else 0


sys.exit(main())
