# SPDX-License-Identifier: MIT
"""site.py SOURCE FOLDER [--bolan PROGRAM] [--gallery all|first]: writes the manual as pages of HTML.

The pages are README.md, docs/*.md, the examples and the files of the project, made by cmark-gfm. Names of functions and
types become links into FOLDER/reference, which doxygen has written before. PROGRAM draws each picture of
docs/gallery.md by the command that stands there. With first it draws a small picture of the first command, and only
checks the options of the rest."""
import argparse
import html
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import xml.etree.ElementTree

try:
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import get_lexer_by_name
    from pygments.util import ClassNotFound
except ImportError:
    sys.exit("python3-pygments is missing")

# Groups of the menu; a page of docs/ that no group names stands in the last one.
GROUPS = (("Start", ("README", "install", "gallery", "examples/index", "command-line", "viewer", "scenes", "python")),
          ("The sea", ("conventions", "sea-states", "formats", "measuring", "accuracy")),
          ("In your program", ("embedding", "porting", "rendering", "how-a-picture-is-made", "threads-and-memory",
                               "errors")),
          ("The papers", ("technique-two-triangle", "technique-exp-cosine", "technique-nested-grid",
                          "technique-flight-sim")),
          ("More", ("index", "CHANGELOG", "CONTRIBUTING", "LICENSE")))
LANGUAGES = {"c": "c", "glsl": "glsl", "py": "python"}

TEMPLATE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<link rel="stylesheet" href="{up}style.css">
<link rel="stylesheet" href="{up}code.css">
</head>
<body>
<div class="bar"><a class="name" href="{up}index.html">Bolan</a><a href="{up}index.html">Manual</a>
<a href="{up}gallery.html">Gallery</a><a href="{up}reference/index.html">Reference</a></div>
<div class="columns">
<nav><details open><summary>Pages</summary>
{menu}</details></nav>
<main class="{name}">
{body}</main>
</div>
<script>if (innerWidth < 832) document.querySelector("details").open = false;</script>
</body>
</html>
"""


class Page:
    """A page of the site: where it comes from, where it goes, and its title."""

    def __init__(self, name, source, target, text):
        self.name, self.source, self.target, self.text = name, source, target, text
        first = re.search(r"^# (.+)$", text, re.M) if source.suffix == ".md" else None
        self.title = re.sub(r"[`*]", "", first.group(1)) if first else name.split("/")[-1]

    @property
    def up(self):
        return "../" * self.target.count("/")


class Site:
    def __init__(self, source, folder, program, gallery):
        self.source, self.folder, self.program, self.gallery = source, folder, program, gallery
        self.pages = {}  # by the source's path
        self.failures = []
        self.names = self.reference_names()
        self.headers = {}

    def fail(self, page, sentence):
        self.failures.append(f"{page.source.relative_to(self.source)}: {sentence}")

    # ---- what there is ----

    def reference_names(self):
        """Where doxygen describes each function, type and macro, from its tag file."""
        found = {}
        for compound in xml.etree.ElementTree.parse(self.folder / "reference" / "bolan.tag").getroot():
            page = compound.findtext("filename", "")
            if compound.get("kind") in ("struct", "union"):
                found[compound.findtext("name")] = page
            if compound.get("kind") == "file":
                found[compound.findtext("path", "").split("include/")[-1] + compound.findtext("name")] = page
                found.setdefault(compound.findtext("name"), page)
            for member in compound.findall("member") if compound.get("kind") == "file" else ():
                found[member.findtext("name")] = f"{member.findtext('anchorfile')}#{member.findtext('anchor')}"
        return {name: target if ".html" in target else f"{target}.html" for name, target in found.items()}

    def add(self, name, path, target):
        self.pages[path] = Page(name, path, target, path.read_text(encoding="utf-8"))

    def find_pages(self):
        self.add("README", self.source / "README.md", "index.html")
        self.pages[self.source / "README.md"].title = "Bolan"
        for name in ("CHANGELOG", "CONTRIBUTING"):
            self.add(name, self.source / f"{name}.md", f"{name.lower()}.html")
        self.add("LICENSE", self.source / "LICENSE", "license.html")
        for path in sorted((self.source / "docs").glob("*.md")):
            target = "manual.html" if path.stem == "index" else f"{path.stem}.html"
            if path.stem != "reference":
                self.add(path.stem, path, target)
        for folder in ("examples", "bindings/python/examples"):
            for path in sorted((self.source / folder).iterdir()):
                if path.suffix[1:] in LANGUAGES or path.suffix == ".md":
                    self.add(f"examples/{path.name}", path, f"examples/{path.name}.html")

    # ---- pieces of a page ----

    def highlight(self, text, language):
        try:
            lexer = get_lexer_by_name(language)
        except ClassNotFound:
            return html.escape(text)
        return highlight(text, lexer, HtmlFormatter(nowrap=True))

    def link(self, page, address):
        """Where a link of a source leads on the site."""
        if re.match(r"[a-z]+:", address):
            return address
        path, _, anchor = address.partition("#")
        anchor = f"#{anchor}" if anchor else ""
        if not path:
            return anchor
        wanted = pathlib.Path(os.path.normpath(page.source.parent / path))
        if wanted == self.source / "docs/reference.md":
            return f"{page.up}reference/index.html"
        if wanted in self.pages:
            return page.up + self.pages[wanted].target + anchor
        if wanted in (self.source / "examples", self.source / "bindings/python/examples"):
            return f"{page.up}examples/index.html"
        if wanted.name in self.names and wanted.parent.name == "bolan":
            return f"{page.up}reference/{self.names[wanted.name]}"
        if not wanted.is_file():
            self.fail(page, f"a link leads to {path}, which is not there")
            return "#"
        target = self.folder / "files" / wanted.relative_to(self.source)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(wanted, target)
        return f"{page.up}{target.relative_to(self.folder)}{anchor}"

    def sized(self, match):
        """The size of a picture, so that a page does not move while it loads."""
        path = self.folder / html.unescape(match.group(1))
        head = path.read_bytes()[:24] if path.suffix == ".png" and path.is_file() else b""
        size = ' width="%d" height="%d"' % struct.unpack(">II", head[16:24]) if head[:4] == b"\x89PNG" else ""
        if match.string[match.end():].lstrip().startswith("width="):  # the page says how wide
            size = ""
        return f'<img src="{match.group(1)}"{size} loading="lazy"'

    def code(self, page, match):
        """A name of the reference between backquotes becomes a link to it."""
        name = html.unescape(match.group(1))
        target = self.names.get(name.removesuffix("()"))
        if not target:
            return match.group(0)
        return f'<a href="{page.up}reference/{target}"><code>{match.group(1)}</code></a>'

    def polish(self, page, body):
        seen = {}

        def heading(match):
            level, inner = match.groups()
            slug = html.unescape(re.sub(r"<[^>]*>", "", inner)).lower()
            slug = re.sub(r"[^\w\- ]", "", slug).replace(" ", "-")
            seen[slug] = seen.get(slug, -1) + 1
            name = f"{slug}-{seen[slug]}" if seen[slug] else slug
            return f'<h{level} id="{html.escape(name)}">{inner}</h{level}>'

        body = re.sub(r"<h([1-6])>(.*?)</h\1>", heading, body, flags=re.S)
        body = re.sub(r'(?<= (?:href)=")([^"]*)|(?<= src=")([^"]*)',
                      lambda m: html.escape(self.link(page, html.unescape(m.group(0)))), body)
        body = re.sub(r'<img src="([^"]*)"', self.sized, body)
        body = re.sub(r'<pre><code class="language-(\w+)">(.*?)</code></pre>',
                      lambda m: f"<pre><code>{self.highlight(html.unescape(m.group(2)), m.group(1))}</code></pre>",
                      body, flags=re.S)
        # Outside of links and of blocks.
        parts = re.split(r"(<pre>.*?</pre>|<a .*?</a>)", body, flags=re.S)
        parts[::2] = [re.sub(r"<code>([^<]*)</code>", lambda m: self.code(page, m), part) for part in parts[::2]]
        return re.sub(r"(<table>.*?</table>)", r'<div class="table">\1</div>', "".join(parts), flags=re.S)

    def body(self, page):
        if page.source.suffix == ".md":
            made = subprocess.run(["cmark-gfm", "--unsafe", "--width", "0", "-e", "table", "-e", "autolink", "-e",
                                   "strikethrough"], input=page.text, text=True, capture_output=True, check=True).stdout
            return self.polish(page, made)
        language = LANGUAGES.get(page.source.suffix[1:])
        code = self.highlight(page.text, language) if language else html.escape(page.text)
        return f"<h1>{page.title}</h1>\n<pre><code>{code}</code></pre>\n"

    # ---- the gallery ----

    def draw(self, page, command):
        """Runs a command of the gallery, and returns the figure of its picture."""
        words = shlex.split(command)
        picture = words[words.index("-o") + 1]
        made = self.folder / "gallery" / picture
        arguments = [str(made) if word == picture else word for word in words[1:]] + ["--quiet"]
        short = self.gallery == "first"
        if short:
            arguments += ["--size", "64x36", "--quality", "low"] + (["--help"] if made.parent.exists() else [])
        made.parent.mkdir(exist_ok=True)
        run = subprocess.run([self.program, *arguments], capture_output=True, text=True, check=False)
        scene = re.escape(words[2])
        if run.returncode != 0:
            self.fail(page, f"{command}: {run.stderr.strip()}")
            return ""
        if not made.exists():  # the help was printed, which names the scenes
            if not re.search(rf"^SCENE is one of .*\b{scene}\b", run.stdout, re.M):
                self.fail(page, f"{command}: there is no scene {words[2]}")
            return ""
        width, height = struct.unpack(">II", made.read_bytes()[16:24])
        small = made.with_suffix(".jpg")  # a fifth of the PNG's size
        subprocess.run(["ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-i", made, "-q:v", "3", small], check=True)
        made.unlink()
        return (f'<figure><img src="gallery/{small.name}" width="{width}" height="{height}" loading="lazy" '
                f'alt="{html.escape(small.stem)}"></figure>\n')

    def with_pictures(self, page, body):
        def block(match):
            commands = [line for line in re.sub(r"<[^>]*>", "", match.group(1)).split("\n") if " -o " in line]
            figures = [self.draw(page, html.unescape(command)) for command in commands]
            return "".join(figures) + match.group(0)
        return re.sub(r"<pre>(.*?)</pre>", block, body, flags=re.S)

    # ---- the whole ----

    def menu(self, page):
        by_name = {p.name: p for p in self.pages.values()}
        named = {name for _, names in GROUPS for name in names}
        rest = [p.name for p in self.pages.values() if p.name not in named and not p.name.startswith("examples/")]
        out = []
        for title, names in GROUPS:
            out.append(f"<h2>{title}</h2><ul>")
            for name in names + (tuple(rest) if title == GROUPS[-1][0] else ()):
                target, text = f"{name}.html", "Examples"
                if name in by_name:
                    target, text = by_name[name].target, by_name[name].title
                elif name != "examples/index":
                    continue
                here = ' aria-current="page"' if target == page.target else ""
                out.append(f'<li><a href="{page.up}{target}"{here}>{html.escape(text)}</a></li>')
            out.append("</ul>")
        return "\n".join(out) + "\n"

    def write(self, page, body):
        path = self.folder / page.target
        path.parent.mkdir(parents=True, exist_ok=True)
        title = "Bolan" if page.title == "Bolan" else f"{page.title} - Bolan"
        path.write_text(TEMPLATE.format(title=html.escape(title), up=page.up, menu=self.menu(page), body=body,
                                        name=page.name.split("/")[0]), encoding="utf-8")

    def write_examples(self):
        """The list of the examples, each with the first sentence of its first comment."""
        page = Page("examples/index", self.source / "examples", "examples/index.html", "")
        page.title = "Examples"
        rows = []
        for example in self.pages.values():
            if example.name.startswith("examples/"):
                words = re.sub(r"^(//|#) SPDX.*\n", "", example.text)
                first = " ".join(re.sub(r'^(//|#|""")', "", line).strip() for line in words.split("\n")[:3])
                sentence = re.match(r"(.*?[.:])(\s|$)", first)
                rows.append(f'<tr><td><a href="{example.source.name}.html">{example.source.name}</a></td>'
                            f"<td>{html.escape(sentence.group(1) if sentence else first)}</td></tr>")
        self.write(page, '<h1>Examples</h1>\n<p>Small programs that use only the public headers, and the Python '
                         'package.</p>\n<div class="table"><table>' + "\n".join(rows) + "</table></div>\n")

    def make(self):
        self.find_pages()
        for name in ("style.css",):
            shutil.copyfile(pathlib.Path(__file__).parent / name, self.folder / name)
        (self.folder / "code.css").write_text(HtmlFormatter(style="tango").get_style_defs("pre"), encoding="utf-8")
        for page in self.pages.values():
            body = self.body(page)
            if page.name == "gallery" and self.program:
                body = self.with_pictures(page, body)
            self.write(page, body)
        self.write_examples()
        return self.failures


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--bolan", default="")
    parser.add_argument("--gallery", choices=("all", "first"), default="all")
    given = parser.parse_args()
    failures = Site(given.source.resolve(), given.folder.resolve(), given.bolan, given.gallery).make()
    print("\n".join(failures), end="\n" if failures else "")
    return 1 if failures else 0


sys.exit(main())
