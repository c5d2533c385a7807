"""The documents beside the project, taken apart into paragraphs that have a place."""

import re
from pathlib import Path

TITLES = {
    "Understanding Euler Angles": "euler",
    "Understanding Quaternions": "quaternions",
    "Sensors for Orientation Estimation": "sensors",
    "Fundamentals of Attitude Estimation": "estimation",
    "Using Accelerometers to Estimate Position and Velocity": "dead_reckoning",
    "Real-time Validation of Euler Angles Using IMU Data Fusion in Robotic Applications": (
        "validation"
    ),
}
SECTION = re.compile(r"#+ (\d+)\. ")
CAPTION = re.compile(r"(#+ )?(Figure \d|Fig\. \d|Table 1 -|Angle Error|Accelerometer output with)")
NO_PARAGRAPH = re.compile(r"## Abstract|\*P\. Amiri|Keywords|Home Products")
TAG = re.compile(r"\((\d+)\) ?\$\$$")


def places(sources: Path) -> dict[str, dict[str, str]]:
    """Give the text of each place of each document, formulas within it included."""
    found: dict[str, dict[str, str]] = {}
    for name in ("chr_library.md", "amiri_validation.md"):
        text = (sources / name).read_text(encoding="utf-8")
        document, section, paragraph = "", "section 0", 0
        for block in re.split(r"\n\s*\n", text):
            line = block.strip()
            head = re.sub(r"^#+ ", "", line)
            if head in TITLES:
                document, section, paragraph = TITLES[head], "before equation 1", 0
                found[document] = {}
            elif SECTION.match(line):
                section, paragraph = f"section {SECTION.match(line)[1]}", 0
            elif CAPTION.match(line):
                what = CAPTION.match(line)[2]
                what = "Table 1" if what == "Angle Error" else what
                found[document].setdefault(f"{section}, {what}", line)
            elif line and document and not NO_PARAGRAPH.match(line):
                # A formula, or what goes on in lower case after one, is of the paragraph before.
                if paragraph == 0 or not re.match(r"[a-z$\\]|#+ \$", line):
                    paragraph += 1
                place = f"{section}, paragraph {paragraph}"
                found[document][place] = f"{found[document].get(place, '')}\n{line}".strip()
            if document == "validation" and TAG.search(line):
                found[document][f"equation {TAG.search(line)[1]}"] = line
                section, paragraph = f"after equation {TAG.search(line)[1]}", 0
    return found
