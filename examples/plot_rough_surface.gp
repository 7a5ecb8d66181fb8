# The rough slider of rough_surface.toml and the surface below it, the contact zones, and the pressure, as one SVG. From
# the folder that holds `examples`:
#
#   steadyslide solve examples/rough_surface.toml --method variational --cells 65536 --at=-0.99975:0.99975:0.0005 --format csv -o solved.csv
#   gnuplot -c examples/plot_rough_surface.gp solved.csv examples/rough_surface.csv rough_surface.svg
#
# The places of --at are the middles between the points of the trace. There psi is the mean of two points, and the
# surface is psi - gap = u + C. In the contact both curves are the same.

if (ARGC != 3) {
  print "usage: gnuplot -c plot_rough_surface.gp SOLVED TRACE PICTURE"
  exit status 2
}
solved = ARG1
trace = ARG2

first = -1.0
step = 0.0005
points = 4001
from = -0.55
to = 0.45

set encoding utf8
set minussign
set datafile separator ","
set datafile commentschars "#"
array psi[points]
stats trace skip 2 using (psi[int(($1 - first) / step + 1.5)] = $2) nooutput
profile(x) = (k = int((x - first) / step) + 1, (psi[k] + psi[k + 1]) / 2)
in_contact(t) = t < 0

set terminal svg size 900,720 font "Helvetica,14" background "white"
set output ARG3
set multiplot
set xrange [from:to]
set lmargin at screen 0.12
set rmargin at screen 0.97
set key top center horizontal samplen 2
set border 3
set tics nomirror out

set tmargin at screen 0.96
set bmargin at screen 0.56
set format x ""
set yrange [-0.0115:0.022]
set ytics 0.01
set ylabel "height (unit of length)" offset 0.5
plot solved using 1:(profile($1)) with lines lw 1.2 lc rgb "#b03030" title "profile ψ", \
     solved using 1:(profile($1) - $4) with lines lw 1.2 lc rgb "#2060a0" title "surface u + C", \
     solved using ($1 - step / 2):(in_contact($2) ? -0.0105 : NaN):(step):(0) with vectors nohead lw 7 lc rgb "#404040" title "contact zones"

set tmargin at screen 0.52
set bmargin at screen 0.10
set format x "%g"
set xlabel "x (unit of length)"
set yrange [0:*]
set ytics auto
set ylabel "pressure −t / E" offset 0.5
set arrow 1 from 0, graph 0 to 0, graph 1 nohead dt 2 lc rgb "#808080"
set label 1 "f = 0.1" at -0.01, graph 0.93 right
set label 2 "f = 0.4" at 0.01, graph 0.93 left
plot solved using 1:(-$2) with lines lw 1 lc rgb "#2060a0" notitle
unset multiplot
