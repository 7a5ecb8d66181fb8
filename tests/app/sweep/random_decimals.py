"""Prints the random values that docs/sweep.md defines, computed with Python's integers: NAME SEED FROM TO COUNT."""
import sys
from fractions import Fraction

name, seed, first, last, count = sys.argv[1], int(sys.argv[2]), Fraction(sys.argv[3]), Fraction(sys.argv[4]), int(sys.argv[5])
below = 2**64

state = 14695981039346656037
for byte in name.encode():
    state = (state ^ byte) * 1099511628211 % below
state ^= seed
for _ in range(count):
    state = (state + 11400714819323198485) % below
    z = (state ^ state >> 30) * 13787848793156543929 % below
    z = (z ^ z >> 27) * 10723151780598845931 % below
    z ^= z >> 31
    print(first + (last - first) * Fraction(z * 10**12 // below, 10**12))
