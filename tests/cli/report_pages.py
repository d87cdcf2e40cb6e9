"""Checks the properties of pages that report_pages.sh states.

    report_pages.py FOLDER PAGE...
"""
import html.parser
import os
import re
import subprocess
import sys
import xml.etree.ElementTree

folder, pages = sys.argv[1], sys.argv[2:]
os.chdir(folder)

# Other tags and attributes in a page would come from a text.
known_tags = set(
    "html head meta link title style body header h1 h2 h3 p main section ul li span b i div table caption thead tbody tr th td"
    " details summary pre code figure img figcaption a br sub script noscript footer".split())
known_attributes = set(
    "lang charset http-equiv content name rel href id class aria-label scope tabindex role src alt title download type style"
    " data-first data-second data-names data-picture".split())
without_end = {"meta", "link", "img", "br"}
faults = []


def fault(page, what):
    faults.append(f"{page}: {what}")


class Page(html.parser.HTMLParser):
    def __init__(self, name):
        super().__init__()
        self.name, self.open, self.ids, self.text, self.scripts = name, [], [], [], []
        self.commands, self.command = [], None
        self.inside = None  # the element whose text is invisible

    def handle_starttag(self, tag, attributes):
        if tag not in known_tags:
            fault(self.name, f"an element {tag}")
        for key, value in attributes:
            if key not in known_attributes:
                fault(self.name, f"an attribute {key} of {tag}")
            if key in ("href", "src") and not value.startswith("data:") and not re.fullmatch(r"#left=\d+", value):
                fault(self.name, f"a link to {value[:60]}")
            if key == "id":
                self.ids.append(value)
        if tag == "script":
            self.scripts.append(dict(attributes).get("type", "program"))
        if tag == "code" and self.open[-1] == "div":
            self.command = ""
        if tag not in without_end:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            fault(self.name, f"</{tag}> ends {self.open[-1:]}")
        else:
            self.open.pop()
        if tag == "code" and self.command is not None:
            self.commands.append(self.command)
            self.command = None

    def handle_data(self, data):
        if self.command is not None:
            self.command += data
        if self.open and self.open[-1] not in ("script", "style"):
            self.text.append(data)


def svg_pictures(source):
    """The names of the elements of each SVG picture of a page."""
    import base64
    for data in re.findall(r"data:image/svg\+xml;base64,([A-Za-z0-9+/=]+)", source):
        root = xml.etree.ElementTree.fromstring(base64.b64decode(data))
        yield {element.tag.split("}")[1] for element in root.iter()}


def read(name):
    source = open(name + ".html", encoding="utf-8").read()
    if len(source.encode()) > 10_000_000:
        fault(name, f"{len(source)} bytes")
    page = Page(name)
    page.feed(source)
    page.close()
    if page.open:
        fault(name, f"left open: {page.open}")
    for one in {i for i in page.ids if page.ids.count(i) > 1}:
        fault(name, f"two elements with the id {one}")
    if page.scripts.count("program") > 1:
        fault(name, f"scripts: {page.scripts}")
    for tags in svg_pictures(source):
        if tags & {"script", "image", "a", "foreignObject"}:
            fault(name, f"a picture with {tags}")
    return page


fine = {"check": (0, 1), "compare": (0, 1), "study": (0, 1), "explain": (0, 1), "review": (0, 1), "replay": (0, 1, 4)}
done = set()
for name in pages:
    page = read(name)
    text = "".join(page.text)
    if name == "one" and "<script>window.evil=1</script>" not in text:
        fault(name, "the summary is not seen as it was written")
    if not page.commands:
        fault(name, "no commands")
    for command in page.commands:
        # Each of these pages has a command that makes it again; the others differ in their files.
        kind = "report" if command.startswith("./morula report") else command
        if kind in done:
            continue
        done.add(kind)
        if not command.startswith("./morula "):
            fault(name, f"not a command of Morula: {command}")
            continue
        run = subprocess.run(command, shell=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if run.returncode not in fine.get(command.split()[1], (0,)):
            fault(name, f"exit {run.returncode}: {command}\n{run.stdout.decode(errors='replace')[-600:]}")

# Others may have changed a database: its texts stay texts in the page.
import sqlite3

with sqlite3.connect("failed.db") as database:
    database.execute("UPDATE run SET failure = 'step 1; <script>alert(7)</script><b>x', command = '<img src=x onerror=alert(8)>'")
subprocess.run([os.environ["RESEAL"], "failed.db"], check=True)  # like an attacker who knows of digests
run = subprocess.run("./morula report failed.db -o changed.html --quiet --frames 0", shell=True, check=False)
if run.returncode == 0:
    page = read("changed")
    if "<script>alert(7)</script>" not in "".join(page.text):
        fault("changed", "the failure is not seen as it is stored")
else:
    fault("changed", f"exit {run.returncode}")

print(f"{len(pages)} pages, {len(done)} commands")
print("\n".join(faults))
sys.exit(1 if faults else 0)
