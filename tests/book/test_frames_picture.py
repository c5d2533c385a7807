"""The picture on the page on conventions has words, colours of the palette, and dashes."""

import re

from chr_notes.book import frames_picture


def test_the_picture_has_words_and_more_than_colour() -> None:
    drawn = frames_picture.picture()
    text = frames_picture.generated()["frames.md"]
    assert f'alt="{drawn.alt}"' in text
    assert f"<figcaption>{drawn.caption}</figcaption>" in text
    assert drawn == frames_picture.picture()
    # y and z have each their own dashes, in their own colour; x has none.
    for letter, dashed in (("x", False), ("y", True), ("z", True)):
        lines = re.findall(rf"style=\"([^\"]*stroke: var\(--{letter}\)[^\"]*)\"", drawn.svg)
        assert len(lines) >= 4  # two axes of frames, a turn and its head
        assert any("stroke-dasharray" in line for line in lines) is dashed
