"""Is this signal periodic? What platform/cortexm/windows.c says on a microcontroller, line for line, and a picture.

    python3 windows.py [D [PICTURE.svg]]

Points are in the plane, D = 2, or in space, 3. The picture has the signal, what was decided of each window, how
periodic it is, and a window of each of the ten kinds of signal as points of the plane."""
import sys

import numpy as np

import netmesh
from netmesh.errors import Flat, OutOfMemory

POINTS, LAG, HOP, WINDOWS, STRETCH, PERIODIC = 64, 5, 16, 1000, 1600, 67
LEAST = 8  # the radius at which a loop that counts is filled
MOVED = {2: 0.7072, 3: 0.8661}  # a point, where each sample was rounded
MEMORY = {2: 9940, 3: 49640}  # netmesh_plan, and a quarter
KINDS = ["silence", "a tone", "last digit", "clipped tone", "chirp", "noise", "two tones", "square wave",
         "steps and noise", "fading tone"]


# ---- the signal ------------------------------------------------------------------------------------------------------


def sine(phase, times):
    half = phase & 0x7FFF
    arch = half * (0x8000 - half) >> 13
    y = (arch * (25395 + (7373 * arch >> 15)) >> 15) * times >> 15
    return -y if phase & 0x8000 else y


def noise(number, below):
    number = number * 2654435761 & 0xFFFFFFFF
    number = (number ^ number >> 15) * 2246822519 & 0xFFFFFFFF
    number = (number ^ number >> 13) * 3266489917 & 0xFFFFFFFF
    return (number >> 16) % below


def sensor(number):
    at, turn = number % STRETCH, 3079 * number
    kind = KINDS[number // STRETCH % 10]
    if kind == "silence":
        s = 0
    elif kind == "a tone":
        s = sine(turn, 1500) + noise(number, 17) - 8
    elif kind == "last digit":
        s = noise(number, 3) - 1
    elif kind == "clipped tone":
        s = sine(turn, 4000)
    elif kind == "chirp":
        s = sine(1000 * at + 4 * at * at, 1800)
    elif kind == "noise":
        s = noise(number, 4096) - 2048
    elif kind == "two tones":
        s = sine(turn, 900) + sine(4982 * number, 900)
    elif kind == "square wave":
        s = 1500 if number % 24 < 12 else -1500
    elif kind == "steps and noise":
        s = noise(number, 2000) if number % 15 < 5 else -1000 if number % 15 < 10 else 1000
    else:
        s = sine(turn, 150 - 150 * at // STRETCH)
    return max(0, min(4095, 2048 + s))


# ---- windows ---------------------------------------------------------------------------------------------------------


def points_of(signal, first, dim):
    return np.stack([signal[first + k * LAG:first + k * LAG + POINTS] for k in range(dim)], axis=1)


def percent(diagram, dim):
    """Between which percentages 100 (1 - birth / death) of the best loop is, of all signals that give these samples."""
    moved = MOVED[dim]
    low, high = 0, 100 * 2 * moved / LEAST
    for birth, death in diagram.intervals(1).tolist():
        if death - moved >= LEAST:
            low = max(low, 100 * (1 - (birth + moved) / (death - moved)))
        if death + moved >= LEAST:
            high = max(high, 100 if birth <= moved else 100 * (1 - (birth - moved) / (death + moved)))
    return low, high


def decide(signal, dim):
    """Of each window what is decided, and low and high, None where it has no diagram; and one word of all diagrams."""
    decided, word = [], 0
    for i in range(WINDOWS):
        points = points_of(signal, i * HOP, dim)
        if (points == points[0]).all(axis=0).any():  # persist would leave the coordinate out; the call in C does not
            decided.append(("flat", None))
            continue
        try:
            diagram = netmesh.persist(points, filter="alpha", memory=MEMORY[dim])
        except Flat:
            decided.append(("flat", None))
        except OutOfMemory:
            decided.append(("out of memory", None))
        else:
            low, high = percent(diagram, dim)
            what = "periodic" if low >= PERIODIC else "not periodic" if high < PERIODIC else "unsure"
            decided.append((what, (low, high)))
            word = (word * 0x100000001B3 ^ int(diagram.fingerprint, 16)) % 2**64
    return decided, word


def report(decided, word):
    last = None
    for i, (what, bounds) in enumerate(decided):
        if what != last:
            print("window %d: %s" % (i, what) +
                  (", %d to %d percent" % (bounds[0], min(int(bounds[1]) + 1, 100)) if bounds else ""))
        last = what
    counts = [(what, sum(what == other for other, _ in decided)) for what in COLOURS]
    print(", ".join("%s: %d" % count for count in counts))
    print("fingerprint %d %d" % divmod(word, 2**32))


# ---- the picture -----------------------------------------------------------------------------------------------------

COLOURS = {"periodic": "#bfe3c4", "not periodic": "#e6e8ec", "unsure": "#f6c26b", "flat": "#c9d8f0",
           "out of memory": "#efb8b8"}


def path(points, attributes):
    return '<path d="M%s" %s/>' % ("L".join("%.1f %.1f" % point for point in points), attributes)


def text(x, y, words, anchor="middle"):
    return '<text x="%.1f" y="%.1f" text-anchor="%s">%s</text>' % (x, y, anchor, words)


def picture(signal, decided):
    left, width, top, height, gap = 40, 900, 30, 110, 24

    def x_of(window):
        return left + width * window / WINDOWS

    def y_of_sample(sample):
        return top + height * (1 - sample / 4095)

    def y_of_percent(value):
        return top + height + gap + height * (1 - value / 100)

    out = ['<svg xmlns="http://www.w3.org/2000/svg" width="960" height="440" font-family="sans-serif" font-size="11">',
           '<rect width="960" height="440" fill="#fff"/>']
    # Behind signal and percentages: what was decided.
    begin = 0
    for i in range(1, WINDOWS + 1):
        if i == WINDOWS or decided[i][0] != decided[begin][0]:
            out.append('<rect x="%.1f" y="%d" width="%.1f" height="%d" fill="%s"/>' % (
                x_of(begin), top, x_of(i) - x_of(begin), 2 * height + gap, COLOURS[decided[begin][0]]))
            begin = i
    # The signal: least and largest sample of each hop.
    hops = [signal[i * HOP:(i + 1) * HOP] for i in range(WINDOWS)]
    upper = [(x_of(i), y_of_sample(max(hop))) for i, hop in enumerate(hops)]
    lower = [(x_of(i), y_of_sample(min(hop)) + .5) for i, hop in enumerate(hops)]
    out.append(path(upper + lower[::-1], 'fill="#1f5fa8"'))
    # How periodic.
    for value in (0, PERIODIC, 100):
        out.append(text(left - 6, y_of_percent(value) + 4, "%d%%" % value, "end"))
    bar = y_of_percent(PERIODIC)
    out.append(path([(left, bar), (left + width, bar)], 'stroke="#888" stroke-dasharray="4 3"'))
    begin = 0
    while begin < WINDOWS:
        end = begin
        while end < WINDOWS and (decided[end][1] is None) == (decided[begin][1] is None):
            end += 1
        if decided[begin][1] is not None:
            band = [(x_of(i), y_of_percent(decided[i][1][1])) for i in range(begin, end)]
            band += [(x_of(i), y_of_percent(decided[i][1][0]) + .5) for i in range(begin, end)][::-1]
            out.append(path(band, 'fill="#a03030" stroke="#a03030"'))
        begin = end
    # A window of each kind.
    side, base = width / 10, top + 2 * height + gap + 40
    for k, kind in enumerate(KINDS):
        out.append(text(x_of(100 * k + 50), top - 8, kind))
        points = [(left + k * side + 6 + (side - 12) * x / 4095, base + (side - 12) * (1 - y / 4095))
                  for x, y in points_of(signal, (100 * k + 50) * HOP, 2).tolist()]
        out.append('<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f" fill="none" stroke="#bbb"/>' % (
            left + k * side + 3, base - 3, side - 6, side - 6))
        out.append(path(points, 'fill="none" stroke="#9db8da" stroke-width=".5"'))
        dots = "".join("M%.1f %.1fh0" % point for point in points)
        out.append('<path d="%s" stroke="#1f5fa8" stroke-width="3" stroke-linecap="round"/>' % dots)
    out.append(text(left, base - 12, "a window of each: s[i] to the right, s[i + %d] upwards" % LAG, "start"))
    for k, (what, colour) in enumerate(COLOURS.items()):
        x, y = left + 130 * k, base + side + 16
        out.append('<rect x="%d" y="%.1f" width="14" height="10" fill="%s"/>' % (x, y - 9, colour))
        out.append(text(x + 20, y, what, "start"))
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    dim = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    signal = np.array([sensor(number) for number in range(WINDOWS * HOP + POINTS + 2 * LAG)], dtype=np.float32)
    decided, word = decide(signal, dim)
    report(decided, word)
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", encoding="utf-8") as file:
            file.write(picture(signal, decided))


if __name__ == "__main__":
    main()
