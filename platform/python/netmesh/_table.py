"""Tables of numbers in text, read as the program netmesh reads them (tools/io/table.hpp has the rules): what it takes
here is what it takes there. What that one decides by other options is refused here, with the line."""
import csv
import gzip
import os
import re
import warnings
import zlib
from typing import NamedTuple, Optional, Sequence, Union

import numpy as np

from ._foreign import foreign
from ._hints import did_you_mean
from ._options import known
from ._slips import slips_of
from .errors import InvalidArgument

BLANKS = " \t\r\v\f"
NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?\Z")
NOT_FINITE = re.compile(r"[+-]?(nan|inf|infinity)\Z", re.I)
HAS_LETTER = re.compile("[A-Za-z\u0080-\U0010ffff]")
MISSING = {"", "na", "n/a", "null", "none", "-", "--", ".", "?", "missing", "#n/a", "nan", "-nan"}
INDEX_NAMES = {"index", "id", "idx", "row", "rowid", "row_id", "no", "no.", "nr", "nr.", "rownames", "row.names", "#",
               "point_id", "pointid", "fid", "objectid", "", "unnamed: 0"}
WORD = object()  # what a field is that is no number


class Table(NamedTuple):
    """What :func:`read_table` gives."""

    points: np.ndarray  #: float64 [n, D], the columns that are taken
    names: list         #: of the header, for all columns; empty without one
    lines: list         #: of each row the line of the text, from 1
    notes: list         #: what was left out or understood

    def __repr__(self) -> str:
        return "<netmesh.Table: %d points in R^%d; notes: %d>" % (*self.points.shape, len(self.notes))


class _Line(NamedTuple):
    text: str
    number: int
    comment: str = ""  # behind it, from # on


class _Field(NamedTuple):
    text: str
    quoted: bool


def read_table(path: Union[str, os.PathLike], columns: Union[str, int, Sequence[Union[str, int]], None] = None, *,
               delimiter: Optional[str] = None, skip: int = 0, drop_missing: bool = False, **unknown) -> Table:
    """Reads a table of numbers in text as the program ``netmesh`` does: in the dialects of spreadsheets, with a header
    or an index column or without, cells as RFC 4180 has them.

    columns: names of the header, numbers from 1, ranges "2-4", a list or "x,y" as the tool has them; by default all.
    delimiter: what stands between columns, " " for blanks; by default what fits all lines.
    skip: lines left out at the top.
    drop_missing: rows that lack a value in a column that is taken are left out; else they are refused.

    What can be read in two ways is refused: InvalidArgument with the line, from 0, as ``row``. What may be no
    coordinate (degrees, times, counts, marks of missing values, names of labels) is taken, and warned of.
    """
    known(read_table, unknown, set())
    with open(path, "rb") as file:
        content = file.read()
    if content[:2] == b"\x1f\x8b":
        try:
            content = gzip.decompress(content)
        except (OSError, EOFError, zlib.error) as error:
            raise InvalidArgument("%s: packed by gzip, and cut off or damaged: %s" % (path, error), "path") from None
    other = foreign(content) if not skip else ""
    if other:
        raise InvalidArgument("%s: %s" % (path, other), "path")
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        text = content.decode("utf-16")
    else:
        text = content.decode("utf-8", "surrogateescape")
    try:
        return parse_table(text, columns, delimiter, skip, drop_missing,
                           lambda slip: warnings.warn("%s: %s" % (path, slip), stacklevel=4))
    except InvalidArgument as error:
        error.args = (_of_file(path, error.args[0]),)
        raise


def _of_file(path, message):
    """What is said of a text, as the tool says it of a file: its name first, then the line."""
    return re.sub(r"\Apath(?:, line (\d+))?: |\A", lambda found: "%s%s: " % (
        path, ":" + found.group(1) if found.group(1) else ""), message, count=1)


def _refuse(line, words):
    raise InvalidArgument("path, line %d: %s" % (line.number, words), "path", line.number - 1)


def _end_with_breaks(text, start, end):
    """The end of the line that begins at ``start``, whose first end is at ``end``, with ends of lines in quotes."""
    begins, at = True, start
    while at < end:
        if text[at] != '"' or not begins:
            begins = text[at] in ",;|\t" or (begins and text[at] in BLANKS)
            at += 1
            continue
        begins = False
        at = text.find('"', at + 1)
        while at >= 0 and text[at + 1:at + 2] == '"':
            at = text.find('"', at + 2)
        if 0 <= at < end:
            at += 1
            continue
        if at < 0:
            return end
        behind = re.compile(r"[ \r]*").match(text, at + 1).end()
        if behind < len(text) and text[behind] not in "\n,;|\t":
            return end
        found = text.find("\n", at)
        end = len(text) if found < 0 else found
        at += 1
    return end


def _without_comment(line):
    if re.match(r"[ \t\r\v\f]*(%|//)", line):
        return ""
    quoted = False
    for i, c in enumerate(line) if "#" in line else ():
        if c == '"':
            quoted = not quoted
        if c != "#" or quoted:
            continue
        before = line[:i].strip(BLANKS)
        of_tabs = line[i - 1:i] == "\t" and "\t" in line[i:]
        # Site #3, in a cell
        of_words = (line[i + 1:i + 2] not in BLANKS and re.search(r"[,;|\t]", line[i:]) and
                    HAS_LETTER.match(re.split(r"[ \t\r\v\f,;|]", before)[-1]))
        if not before or (line[i - 1] in BLANKS and not of_tabs and before[-1] not in ",;|" and not of_words):
            return line[:i]
    return line


def _lines_of(text, skip):
    text = text[1:] if text[:1] == "\ufeff" else text
    text = text[:-1] if text[-1:] == "\x1a" else text
    if "\n" not in text:
        text = text.replace("\r", "\n")
    lines, start, number, above = [], 0, 0, ""
    while start < len(text):
        number += 1
        found = text.find("\n", start)
        first = len(text) if found < 0 else found
        end = _end_with_breaks(text, start, first) if number > skip and '"' in text[start:first] else first
        whole, own = text[start:end].rstrip("\r"), number
        number += text.count("\n", start, end)
        start = end + 1
        if own <= skip:
            continue
        if end == first and "\r" in whole:
            _refuse(_Line("", own), "a carriage return within the line; save the file with one kind of line ends")
        kept = _without_comment(whole)
        line = kept.rstrip(" " if kept == whole else BLANKS)
        if line.strip(BLANKS):
            lines.append(_Line(line, own, whole[len(kept):]))
        elif not lines:
            above = whole.lstrip("#%/ \t\r") or above
    return lines, above


def _cut(line, delimiter):
    """Fields of a line; None where a quotation does not end. "" as delimiter: several together."""
    if '"' not in line:  # the usual case
        if delimiter == " ":
            return [_Field(part, False) for part in re.split(r"[ \t\r\v\f]+", line.strip(BLANKS)) if part]
        if delimiter != "":
            return [_Field(part.strip(BLANKS), False) for part in line.split(delimiter)]
    stops = {" ": BLANKS, "": BLANKS + ",;"}.get(delimiter, delimiter)
    line = line.strip(BLANKS) if delimiter in (" ", "") else line
    fields, at, due = [], 0, True
    while True:
        while at < len(line) and line[at] in BLANKS and (delimiter == " " or line[at] != delimiter):
            at += 1
        if at >= len(line):
            if due and delimiter != " " and (delimiter or fields):
                fields.append(_Field("", False))
            return fields
        stop = at
        if line[at] == '"':
            stop = at + 1
            while stop < len(line) and (line[stop] != '"' or line[stop + 1:stop + 2] == '"'):
                stop += 2 if line[stop] == '"' else 1
            if stop >= len(line):
                return None
            behind = stop + 1
            while behind < len(line) and line[behind] not in stops:
                behind += 1
            quoted = not line[stop + 1:behind].strip(BLANKS)
            fields.append(_Field((line[at + 1:stop] if quoted else line[at:behind]).strip(BLANKS), quoted))
            at = behind
        else:
            while stop < len(line) and line[stop] not in stops:
                stop += 1
            fields.append(_Field(line[at:stop].strip(BLANKS), False))
            at = stop
        while delimiter == "" and at < len(line) and line[at] in BLANKS:
            at += 1
        due = at < len(line) and (line[at] in ",;" if delimiter == "" else line[at] == delimiter)
        at += due and delimiter != " "


def _value_of(text, decimal_comma):
    """A number, infinity for what is no finite one, None for nothing, or WORD."""
    if not text:
        return None
    if decimal_comma and "," in text:
        if "." in text or not re.match(r"[^,]*[0-9],[0-9][^,]*\Z", text):
            return WORD
        text = text.replace(",", ".")
    if NUMBER.match(text):
        return float(text)
    return np.inf if NOT_FINITE.match(text) else WORD


def _is_header(fields):
    if len(fields) > 2 and not fields[0].text and all(f.text == str(i) for i, f in enumerate(fields[1:])):
        return True
    texts = [field.text for field in fields if field.text]
    return bool(texts) and all(_value_of(text, True) is WORD and not re.match(r'["0-9.+-]', text) and
                               HAS_LETTER.search(text) for text in texts)


class _Look:
    """How lines look, cut in one way."""

    def __init__(self, lines, delimiter, decimal_comma):
        self.even, self.width, good = True, 0, True
        self.commas = self.points = self.digits = self.inner_blanks = self.words = False
        self.thousands = True
        for line in lines:
            fields = _cut(line.text, delimiter)
            if fields is None:
                self.even = False
                continue
            self.width = self.width or len(fields)
            self.even = self.even and len(fields) == self.width
            for text, _ in fields:
                value = _value_of(text, decimal_comma)
                if value is None:
                    continue
                if value is not WORD:
                    self.points = self.points or "." in text
                    if decimal_comma and "," in text:
                        self.commas = True
                        self.thousands = self.thousands and bool(re.match(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}\Z", text))
                elif HAS_LETTER.search(text):
                    self.words = True
                else:
                    self.inner_blanks = self.inner_blanks or " " in text or "\t" in text
                    self.digits = self.digits or bool(re.search(r"[0-9] [0-9]{3}(?![0-9])", text))
                    good = False
        self.consistent = good and self.even
        self.thousands = self.thousands and self.commas


class _Dialect(NamedTuple):
    delimiter: str
    decimal_comma: bool


BOTH = "points and commas are both decimal here; write numbers in one way"
GROUPED = "commas may be decimal or group thousands (1,234): say delimiter, which reads them as decimal"
GROUPED_BY_POINTS = ("points may be decimal or group thousands (1.234), as whole numbers below 1000 stand beside them: "
                     "say delimiter, which reads them as decimal, or write numbers without signs between thousands")
TWO_WAYS = "commas may be decimal or stand between columns: write points in place of decimal commas"


def _points_may_group(lines, delimiter):
    """1.500 beside 300 in a column: every point may group thousands; 0, 0.500, 1.5 or 1500 speak against it."""
    columns, points = {}, 0
    for line in lines:
        fields = _cut(line.text, delimiter)
        if fields is None:
            return False
        for k, (text, _) in enumerate(fields):
            if not NUMBER.match(text):
                continue
            if "." in text:
                if not re.match(r"[+-]?[1-9][0-9]{0,2}\.[0-9]{3}\Z", text):
                    return False
                points += 1
                kind = "points"
            elif re.match(r"[+-]?[0-9]+\Z", text):
                digits = text.lstrip("+-")
                kind = "" if digits[0] == "0" else "short" if len(digits) < 4 else "long"
            else:
                return False
            columns.setdefault(k, set()).add(kind)
    return points > 1 and any({"points", "short"} <= kinds and "long" not in kinds for kinds in columns.values())


class _Finder:
    """Which delimiter fits all lines, and whether numbers have decimal commas."""

    def __init__(self, lines, names, notes):
        self.lines, self.names, self.notes = lines, names, notes
        self.outside = [re.sub(r'(^|[,;|\t ])"[^"]*"', r'\1"', line.text.strip(BLANKS)) for line in lines]

    def holds(self, mark):
        return sum(mark in line[:-1] for line in self.outside)

    def any(self, pattern):
        return any(re.search(pattern, line) for line in self.outside)

    def decimal(self, delimiter):
        self.notes.append("commas read as decimal")
        return _Dialect(delimiter, True)

    def by(self, delimiter):
        strict = _Look(self.lines, delimiter, True)
        if strict.digits:
            _refuse(self.lines[0], "blanks within numbers (1 234): write them without")
        if strict.thousands:
            _refuse(self.lines[0], GROUPED)
        if strict.consistent or (not strict.inner_blanks and not self.holds(",")):
            if strict.commas and strict.points:
                _refuse(self.lines[0], BOTH)
            return self.decimal(delimiter) if strict.commas else _Dialect(delimiter, False)
        mixes = delimiter != "|" and not self.any(r"[0-9],[0-9]") and _Look(self.lines, "", False).consistent
        return _Dialect("", False) if mixes else _Dialect(delimiter, self.holds(",") > 0)

    def by_commas(self):
        strict = _Look(self.lines, ",", True)
        if strict.thousands:
            _refuse(self.lines[0], GROUPED)
        if strict.commas:
            return _refuse(self.lines[0], BOTH) if strict.points else self.decimal(",")
        if self.any(r",0[0-9]") and all(self.are_halves(_cut(line.text, ",")) for line in self.lines):
            _refuse(self.lines[0], "numbers behind commas begin with zeros, as decimals do: part columns by something "
                                   "else")
        if self.holds(" ") + self.holds("\t"):
            blanks = _Look(self.lines, " ", True)
            if blanks.consistent and blanks.commas and blanks.width > 1:
                _refuse(self.lines[0], TWO_WAYS)
        if all(re.search(r",[ \t]", line) and re.search(r"[0-9],[0-9]", line) for line in self.outside):
            _refuse(self.lines[0], TWO_WAYS)
        if not strict.inner_blanks or self.names == strict.width:
            return _Dialect(",", False)
        mixed = _Look(self.lines, "", False)
        if not (mixed.width > strict.width and mixed.consistent and not mixed.words):
            return _Dialect(",", False)
        self.notes.append("commas and blanks part columns, %d of them" % mixed.width)
        return _Dialect("", False)

    @staticmethod
    def are_halves(fields):
        return fields is not None and len(fields) % 2 == 0 and all(
            not quoted and re.match((r"\+?" if i % 2 else r"[+-]?") + r"[0-9]+\Z", text)
            for i, (text, quoted) in enumerate(fields))

    def find(self):
        dialect = self.find_delimiter()
        if dialect.delimiter != "," and not dialect.decimal_comma and _points_may_group(self.lines, dialect.delimiter):
            _refuse(self.lines[0], GROUPED_BY_POINTS)
        return dialect

    def find_delimiter(self):
        count = len(self.lines)
        for mark in "|;":
            if self.holds(mark) == count:
                return self.by(mark)
        tabs = [line.text.count("\t") for line in self.lines]
        leading = all(line.text[0] == "\t" for line in self.lines)
        if self.holds("\t") == count and not leading and (
                len(set(tabs)) == 1 or not _Look(self.lines, " ", False).even):
            return self.by("\t")
        if self.holds(",") == count and (not self.holds(";") or (
                _Look(self.lines, ",", False).even and not _Look(self.lines, "", False).consistent)):
            return self.by_commas()
        blanks = _Look(self.lines, " ", True)
        if not self.holds(","):
            bars = self.holds("|") > 0 and not blanks.consistent
            return _Dialect("|" if bars else "" if self.holds(";") else " ", False)
        if not blanks.consistent:
            plain = any(re.match(r"[0-9.+\-eE \t]+\Z", line) and re.search(r"[ \t]", line) for line in self.outside)
            if plain and not blanks.points and self.any(r"[0-9],[0-9]"):
                _refuse(self.lines[0], "a comma between digits where other lines are parted by blanks: a decimal one, "
                                       "or a delimiter?")
            return _Dialect("", False)
        if not blanks.commas:
            return _Dialect("", False)
        if _Look(self.lines, "", False).consistent:
            _refuse(self.lines[0], TWO_WAYS)
        if blanks.points:
            return _Dialect("", False)
        return _refuse(self.lines[0], GROUPED) if blanks.thousands else self.decimal(" ")


def _choose(wanted, width, names):
    """Columns from 0 out of numbers from 1, ranges and names."""
    chosen = []
    if isinstance(wanted, (str, int)):  # "x,y" as the tool takes it, where no column is called so
        is_list = isinstance(wanted, str) and wanted not in names
        wanted = next(csv.reader([wanted], skipinitialspace=True), []) if is_list else [wanted]
    for item in wanted:
        item = str(item)
        if item in names and (names.count(item) > 1 or len(names) < width):
            raise InvalidArgument("columns: %s, %s; numbers from 1 say which are meant" % (
                item, "as two columns are called" if names.count(item) > 1 else "where the header names %d columns and "
                "the rows have %d" % (len(names), width)), "columns")
        if item in names and names.index(item) < width:
            chosen.append(names.index(item))
            continue
        found = re.match(r"([0-9]+)(?:-([0-9]+))?\Z", item)
        if found is None:
            header = "; the header names %s" % ", ".join(map(_quoted, names)) if names else "; there is no header"
            raise InvalidArgument("columns: there is no column %s%s%s" % (_quoted(item), header,
                                                                          did_you_mean(item, names)), "columns")
        first, last = int(found.group(1)), int(found.group(2) or found.group(1))
        if not 1 <= first <= last <= width:
            raise InvalidArgument("columns: %s, where there are columns 1 to %d" % (item, width), "columns")
        chosen += range(first - 1, last)
    if not chosen:
        raise InvalidArgument("columns: none is named", "columns")
    if len(set(chosen)) != len(chosen):
        raise InvalidArgument("columns: one stands there twice", "columns")
    return chosen


def _quoted(name):
    return '"%s"' % name


class _Rows:
    def __init__(self, rows, dialect, width, dropped):
        self.rows, self.width, self.dropped = rows, width, dropped
        self.decimal_comma = dialect.decimal_comma

    def is_word_column(self, k):
        def is_text(field):
            return field.quoted or _value_of(field.text, self.decimal_comma) is WORD
        return any(len(f) > k and f[k].text and is_text(f[k]) for f, _ in self.rows) and all(
            len(f) > k and (not f[k].text or is_text(f[k])) for f, _ in self.rows)

    def counts(self, step, first=0):
        texts = [f[0].text if f else "" for f, _ in self.rows[first:]]
        if not all(re.match(r"[0-9]+\Z", text) for text in texts):
            return False
        return all(step(int(a), int(b)) for a, b in zip(texts[1:], texts))

    def lacking(self, chosen):
        """How many rows lack a value."""
        return sum(self.lacks(fields, chosen) for fields, _ in self.rows)

    def lacks(self, fields, chosen):
        return len(fields) == self.width + self.dropped and any(fields[k].text.lower() in MISSING for k in chosen)


def parse_table(text, columns=None, delimiter=None, skip=0, drop_missing=False, tell=lambda slip: None):
    """As read_table, of a string. `tell` gets what may be a coordinate by mistake."""
    (lines, above), notes = _lines_of(text, skip), []
    if not lines:
        signs = sum(line.lstrip(BLANKS)[:1] == "#" for line in re.split("[\r\n]+", text))
        raise InvalidArgument("path: the table ends without a row" + (
            "; %d lines of it begin with #, as comments do: take that sign out" % signs if signs > 1 else ""), "path")
    separator = re.match(r'"?sep=(.)"?\Z', lines[0].text.strip(BLANKS), re.I)
    if separator:
        delimiter = separator.group(1) if delimiter is None else delimiter
        notes.append('skipped line "%s"' % lines.pop(0).text.strip(BLANKS))

    def is_words(by):
        fields = _cut(lines[0].text, by) if lines else None
        return fields is not None and _is_header(fields)
    of_words = is_words("") or is_words(delimiter or "") or (bool(lines) and "|" in lines[0].text and is_words("|"))
    of_quotes = len(lines) > 1 and '"' in lines[0].text and '"' not in lines[1].text
    first = 1 if of_words or of_quotes else 0
    if len(lines) == first:
        raise InvalidArgument("path: the table ends without a row", "path")
    if delimiter is not None:
        dialect = _Dialect(delimiter, True)
    else:
        dialect = _Finder(lines[first:], len(_cut(lines[0].text, ",") or ()) if first else 0, notes).find()

    def parts(line):
        fields = _cut(line.text, dialect.delimiter)
        return _refuse(line, "a quotation that does not end") if fields is None else fields
    names, header = [], parts(lines[0])
    counted = of_quotes and all(f.quoted and f.text in (str(k), str(k + 1)) for k, f in enumerate(header))
    header_line = lines[0]
    if _is_header(header) or counted or of_words:
        names = [f.text.replace('""', '"') if f.quoted else f.text for f in header]
        notes.append('skipped header "%s"' % lines.pop(0).text.strip(BLANKS))
    rows = [(parts(line), line) for line in lines]
    while len(rows) > 1 and not any(field.text for field in rows[-1][0]):
        rows.pop()
    if len(rows) < len(lines):
        notes.append("skipped %d rows of nothing at the end" % (len(lines) - len(rows)))
    dropped = int(all(len(f) > 1 and not f[-1].text for f, _ in rows))
    if dropped:
        notes.append("skipped an empty last column")
    width, top = len(rows[0][0]) - dropped, rows[0][1]
    if dropped and len(names) == width + 1 and not names[-1]:
        names.pop()
    if names and len(names) != width:  # a header may have another delimiter than the rows
        others = _cut(header_line.text, "")
        if others is not None and len(others) == width and _is_header(others):
            names = [f.text for f in others]
    table = _Rows(rows, dialect, width, dropped)
    header_names = names
    names = names or _names_above(above, dialect, width)
    if columns is not None:
        chosen = _choose(columns, width, [""] + names if len(names) + 1 == width else names)
    else:
        chosen = _all_columns(table, dialect, delimiter, header_names, top, notes)
    found = _numbers(table, chosen, names, top, notes, drop_missing)
    slips = slips_of(found.points, chosen, [names[k] for k in chosen] if len(names) == width else [],
                     columns is not None)
    if len(rows) > 1 and all(re.match(r"#[^ \t\r\v\f]", line.comment) for _, line in rows):
        slips.insert(0, 'left out what stands behind # in every row, "%s" first; if it is a column, take that sign '
                     "out" % rows[0][1].comment)
    for slip in slips:
        notes.append(slip)
        tell(slip)
    return found


def _names_above(above, dialect, width):
    """# x,y above the rows, as numpy.savetxt writes names."""
    for delimiter in (dialect.delimiter, ""):
        fields = _cut(above, delimiter)
        if fields and len(fields) == width and _is_header(fields):
            return [f.text.replace('""', '"') if f.quoted else f.text for f in fields]
    return []


def _all_columns(table, dialect, delimiter, names, top, notes):
    rows, width = table.rows, table.width
    by_one = dialect.delimiter not in (" ", "")
    fields = rows[0][0]
    named = sum(map(bool, names))
    if (by_one or all(len(name) < 3 for name in names)) and named > 1 and (
            len(names) != width) and named not in (width, width - 1) and not any(
            _value_of(f.text, table.decimal_comma) is WORD for f in fields):
        _refuse(top, "%d columns where the header names %d" % (width, named))
    if not names and width > 1 and len(rows) > 3 and len(fields) == width and all(
            re.match(r"[0-9]+\Z", f.text) for f in fields):
        head, count = [int(f.text) for f in fields], len(rows) - 1
        if width > 2 and head[0] == count and 1 < head[1] < width and table.counts(lambda a, b: a == b + 1, 1):
            _refuse(top, "is the head of a .node file of Triangle or TetGen, it seems: skip it")
        if head[:2] == [count, width] or (width == 2 and head == [2, count]):
            _refuse(top, "may say how many points of how many coordinates there are, or be a point: skip it")
    if not names and len(rows) > 2 and by_one and width > 1 and delimiter is None and all(
            f.text == str(k) for k, f in enumerate(fields)) and all(
            re.search("[.,eE]", f.text) for row, _ in rows[1:] for f in row):
        _refuse(top, "may be column numbers, as pandas writes them, or a point: skip it")
    short = bool(names) and len(names) + 1 == width
    called = len(names) == width and names[0].lower() in INDEX_NAMES
    if width > 1 and (short or called):
        if not table.counts(lambda a, b: a == b + 1 if short else a > b) and not table.is_word_column(0):
            _refuse(top, "the header says that the first column is no coordinate, but it does not count rows: choose "
                         "columns")
        notes.append("skipped index column 1")
        return list(range(1, width))
    return list(range(width))


def _numbers(table, chosen, names, top, notes, drop_missing):
    rows = table.rows
    kept = [row for row in rows if not table.lacks(row[0], chosen)]
    if drop_missing:
        if not kept:
            _refuse(top, "every row lacks a value")
        notes.append("no row lacks a value" if len(kept) == len(rows) else
                     "left out %d of %d rows, which lack a value" % (len(rows) - len(kept), len(rows)))
    taken = kept if drop_missing else rows
    points = np.empty((len(taken), len(chosen)))
    for i, (fields, line) in enumerate(taken):
        whole = len(fields) == table.width + table.dropped
        for j, k in enumerate(chosen):
            if k >= len(fields):
                break
            value = _value_of(fields[k].text, table.decimal_comma)
            if value is not WORD and value is not None and np.isfinite(value):
                points[i, j] = value + 0.0
            elif whole or value is not None:
                _refuse(line, ("nothing in column %d" % (k + 1) if value is None else '"%s" is not a %s' % (
                    fields[k].text[:40], "number" if value is WORD else "finite double")) +
                    _remedy(table, chosen, names, fields, k))
        if not whole:
            _refuse(line, "%d column%s where line %d has %d" % (
                len(fields), "" if len(fields) == 1 else "s", top.number, table.width + table.dropped))
    return Table(points, names, [line.number for _, line in taken], notes)


def _remedy(table, chosen, names, fields, k):
    """What helps where column k has no number: columns of words are left out before rows that lack a value."""
    others = [c for c in chosen if not table.is_word_column(c)]
    is_wordy = len(others) < len(chosen)
    if is_wordy and (table.is_word_column(k) or table.lacks(fields, chosen)):
        if len(others) < 2:
            return ""
        lacking = table.lacking(others)
        rows = ", and drop_missing=True rows that lack a value, %d of %d" % (lacking, len(table.rows))
        return "; columns=%s leaves columns of words out%s" % (_chosen_text(others, names), rows if lacking else "")
    if not table.lacks(fields, chosen):
        return ""
    count, lacking = len(table.rows), table.lacking(chosen)
    leaves = ": drop_missing=True leaves such rows out, %d of %d" % (lacking, count)
    return "; a row with a missing value has to be left out or filled in" + (leaves if lacking < count else "")


def _chosen_text(columns, names):
    """Columns from 0 as ``columns=`` takes them: their names, where each has one of its own, or numbers."""
    called = [names[c] if c < len(names) else "" for c in columns]
    is_named = all(name and names.count(name) == 1 for name in called)
    return repr(called if is_named else [c + 1 for c in columns])
