"""What people take for coordinates by mistake, told by names and numbers of columns (tools/io/slips.cpp)."""
import re

import numpy as np

_OTHER = {"id", "ids", "uid", "fid", "objectid", "pointid", "idx", "index", "label", "labels", "class",
          "classification", "cluster", "category", "target", "flag", "time", "timestamp", "datetime", "date", "year",
          "frame", "intensity"}
_MISSING = (-99, -999, -9999, -99999, -999999, -999.25, -32768, -2147483648, 9999, 99999, 999999, 32767, 1e20, -1e20,
            1e30, -1e30, 1e36, 9.969209968386869e36, -3.4028234663852886e38, 3.4028234663852886e38)
_SINCE = (("seconds", 1), ("milliseconds", 1e3), ("microseconds", 1e6), ("nanoseconds", 1e9))


def _words(name):
    apart = re.sub("(?<=[a-z])(?=[A-Z])", " ", name)
    return set(re.findall("[a-z\u0080-\U0010ffff]+", re.sub("[A-Z]", lambda c: c.group().lower(), apart)))


def _is_date(x):
    day, month = x % 100, x // 100 % 100
    return bool(np.all((x >= 19000101) & (x <= 21001231) & (x == np.floor(x)) & (day >= 1) & (day <= 31) &
                       (month >= 1) & (month <= 12)))


class _Slips:
    def __init__(self, points, columns, names, chosen):
        self.points, self.columns, self.names, self.chosen = points, columns, names, chosen
        self.others, self.notes = [], []

    def called(self, k):
        return '"%s"' % self.names[k] if self.names and self.names[k] else "column %d" % (self.columns[k] + 1)

    def without(self, left_out):
        left = [self.names[k] if self.names and self.names[k] and self.names.count(self.names[k]) == 1
                else self.columns[k] + 1 for k in range(len(self.columns)) if k not in left_out]
        return "" if len(left) < 2 else "; columns=%r leaves %s out" % (left, "it" if len(left_out) == 1 else "them")

    def find(self):
        if not self.chosen:
            self.find_other_names()
            self.find_counting_column()
            self.find_times()
        self.find_degrees()
        self.find_missing()
        return self.notes

    def find_other_names(self):
        lower = [name.lower() for name in self.names]
        places = "x" in lower and "y" in lower
        self.others = [k for k, name in enumerate(lower) if _words(self.names[k]) & _OTHER or
                       (places and not re.match(r"([t-z]|x[0-9])\Z", name))]
        if len(self.others) == len(self.columns):
            self.others = []
        if self.others:
            self.notes.append("took %s for %s, too%s" % (
                ", ".join(map(self.called, self.others)), "a coordinate" if len(self.others) == 1 else "coordinates",
                self.without(self.others)))

    def find_counting_column(self):
        rows, dim = self.points.shape
        if dim < 3 or rows < 5:
            return
        first = self.points[0]
        found = [k for k in range(dim) if first[k] >= 0 and first[k] == np.floor(first[k]) and
                 np.array_equal(self.points[:, k], first[k] + np.arange(rows))]
        if len(found) == 1 and found[0] not in self.others:
            self.notes.append("took %s, which counts rows, for a coordinate%s" % (
                self.called(found[0]), self.without(found)))

    def find_times(self):
        rows, dim = self.points.shape
        for k in range(dim if rows > 1 else 0):
            x, what = self.points[:, k], None
            for name, scale in _SINCE:
                if np.all((x >= 1e9 * scale) & (x < 2.13e9 * scale)):
                    what = name + " since 1970"
            if _is_date(x):
                what = "dates, as 20240131"
            if what and k not in self.others:
                self.notes.append("took %s, which looks like %s, for a coordinate%s" % (
                    self.called(k), what, self.without([k])))

    def find_degrees(self):
        words = [_words(name) for name in self.names]
        latitude = [k for k, w in enumerate(words) if w & {"lat", "latitude"}]
        longitude = [k for k, w in enumerate(words) if w & {"lon", "lng", "long", "longitude"}]
        if not latitude or not longitude or latitude[-1] == longitude[-1]:
            return
        a, b = latitude[-1], longitude[-1]
        if np.all(abs(self.points[:, a]) <= 90) and np.all(abs(self.points[:, b]) <= 360):
            self.notes.append("%s and %s look like degrees, of which a degree east is shorter than one north: project "
                              "them to metres first" % (self.called(a), self.called(b)))

    def find_missing(self):
        for k in range(len(self.columns)):
            x = self.points[:, k]
            marked = np.isin(x, _MISSING)
            others = x[~marked]
            if not marked.any() or len(others) < 2:
                continue
            mark, low, high = x[marked][-1], others.min(), others.max()
            away = max(low - mark, mark - high)
            if away >= high - low and away >= abs(mark) / 2:
                self.notes.append("%s holds %s, far from its other numbers: if it stands for a missing value, leave "
                                  "such rows out" % (self.called(k), re.sub(r"\.0\Z", "", repr(float(mark)))))


def slips_of(points, columns, names, chosen):
    """Sentences about columns (from 0, of the file) that may be no coordinates; names are theirs, or empty."""
    return _Slips(points, columns, names, chosen).find() if len(points) else []
