# The curves of docs/cost.md: user seconds against the number of jumps, pieces, zones, cells and digits.
#
#   gnuplot -c tests/bench/plot_cost.gp docs/cost.csv cost.svg

if (ARGC != 2) {
  print "usage: gnuplot -c plot_cost.gp CURVES PICTURE"
  exit status 2
}
set terminal svg size 800,560 font "sans-serif,13" background "white"
set output ARG2
set datafile separator ","
set logscale x 2
set logscale y 10
set format x "2^{%L}"
set format y "10^{%L}"
set xlabel "number"
set ylabel "user time of a whole solve, seconds"
set key left top reverse Left
set grid back linecolor rgb "#dddddd"
curves = "jumps parabola-jumps pieces zones traces cells digits"
plot for [curve in curves] ARG1 skip 1 using 2:(strcol(1) eq curve ? $3 : NaN) \
  with linespoints pointtype 7 pointsize 0.4 linewidth 1.5 title curve
