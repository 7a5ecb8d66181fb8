# Pressure and tangential traction of a solved problem, and the gap beside the contact, as SVG:
#
#   steadyslide solve PROBLEM --samples 400 --format csv -o solved.csv
#   gnuplot -c examples/plot_pressure.gp solved.csv pressure.svg
#
# An infinite pressure is cut by the frame, at six times the median pressure under the indenter.

if (ARGC != 2) {
  print "usage: gnuplot -c plot_pressure.gp SOLVED PICTURE"
  exit status 2
}
solved = ARG1

set encoding utf8
set minussign
set datafile separator ","
set datafile missing ""
stats solved skip 1 using ($2 < 0 ? -$2 : NaN) name "P" nooutput
stats solved skip 1 using 4 name "G" nooutput

set terminal svg size 800,560 font "Helvetica,15" background "white"
set output ARG2
set border 3
set tics nomirror out
set key top center horizontal samplen 2
set xlabel "x (unit of length)"
set ylabel "traction (unit of E)"
set yrange [0:(P_max < 6 * P_median ? 1.2 * P_max : 6 * P_median)]
if (G_max > 0) {
  set y2label "gap (unit of length)"
  set y2range [0:*]
  set border 11
  set y2tics nomirror out
  plot solved skip 1 using 1:(-$2) with lines lw 2 lc rgb "#2060a0" title "pressure −t_n", \
       solved skip 1 using 1:(abs($3)) with lines lw 2 dt 2 lc rgb "#b03030" title "|t_t|", \
       solved skip 1 using 1:4 axes x1y2 with lines lw 1.5 dt 4 lc rgb "#606060" title "gap"
} else {
  plot solved skip 1 using 1:(-$2) with lines lw 2 lc rgb "#2060a0" title "pressure −t_n", \
       solved skip 1 using 1:(abs($3)) with lines lw 2 dt 2 lc rgb "#b03030" title "|t_t|"
}
