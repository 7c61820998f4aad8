# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes gnuplot's SVG files smaller without changing what they show: compact_svg.py FILE.svg ...

Leaves out empty groups, markers that no point uses, attributes that repeat a default, and line breaks but one for each
group of the drawing.
"""

import re
import sys


def compact(text):
    text = re.sub(r"<(title|desc)>.*?</\1>|<filter id='greybox'.*?</filter>", "", text, flags=re.S)
    text = text.replace(' stroke-linecap="butt" stroke-linejoin="miter"', "")
    text = text.replace('<tspan font-family="DejaVu Sans" >', "<tspan>")
    text = re.sub(r"\s*\n\s*", " ", text)
    text = re.sub(r">\s+(?=<)", ">", text)
    while (shorter := re.sub(r"<g [^<>]*></g>", "", text)) != text:
        text = shorter
    for _ in range(3):  # a marker may be drawn by another one
        for marker in re.findall(r"id='(gp[A-Za-z]+\d*|textbox)'", text):
            if f"#{marker}'" not in text and f"#{marker})" not in text:
                text = re.sub(rf"<(\w+)(?=[^<>]* id='{marker}')(?:[^<>]*/>|[^<>]*>.*?</\1>)", "", text, count=1)
    return re.sub(r"(?=<g |</svg>)", "\n", text.strip()) + "\n"


for name in sys.argv[1:]:
    with open(name, encoding="utf8") as file:
        smaller = compact(file.read())
    with open(name, "w", encoding="utf8") as file:
        file.write(smaller)
