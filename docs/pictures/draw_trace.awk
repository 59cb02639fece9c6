# Draws the trace of a run in the plane as SVG: the path above, the speeds over time below.
#
#   rob run PROGRAM --fast --trace t.csv
#   awk -v program=PROGRAM -f docs/pictures/draw_trace.awk t.csv > picture.svg
#
# The programmed corners are the targets that stand in the program as numbers: MOVE(140, 40, 0).
# Columns are found by their names. mm, s.

BEGIN {
  FS = ","
  if (v_max == "") v_max = 20            # mm/s, of the gantry's axes
  if (width_mm == "") width_mm = 180     # what the upper picture shows of the plane
  if (height_mm == "") height_mm = 140
  left = 64; right = 822; top = 40; scale = 3.2  # pixels, and pixels a mm
  bottom = top + height_mm * scale
  speed_top = bottom + 92; speed_bottom = speed_top + 168
  read_program()
}

NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }

{
  n = NR - 1
  t[n] = $column["t"]; line[n] = $column["line"]
  x[n] = $column["q1"]; y[n] = $column["q2"]
  vx[n] = $column["qd1"]; vy[n] = $column["qd2"]
  mx[n] = $column["a1"]; my[n] = $column["a2"]
  error = distance(x[n], y[n], mx[n], my[n])
  if (error > worst_error) worst_error = error
}

END {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 " speed_bottom + 56 "\"" \
        " width=\"860\" height=\"" speed_bottom + 56 "\" font-size=\"12.5\" fill=\"#334155\"" \
        " font-family=\"system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif\">"
  print "<rect width=\"100%\" height=\"100%\" rx=\"10\" fill=\"#ffffff\"/>"
  draw_plane()
  draw_path()
  draw_corners()
  draw_program(top + 12)
  draw_key(bottom - 92)
  draw_lanes()
  draw_speeds()
  print "</svg>"
}

# The program's text, and the corners in it: corner_x[l], corner_y[l] of line l.
function read_program(    words, parts) {
  while ((getline words < program) > 0) {
    source[++lines] = words
    if (!match(words, /MOVE\([^)]*\)/)) continue
    split(substr(words, RSTART + 5, RLENGTH - 6), parts, ",")
    corner_x[lines] = parts[1] + 0
    corner_y[lines] = parts[2] + 0
  }
}

function px(mm) { return left + mm * scale }
function py(mm) { return bottom - mm * scale }
function tx(s) { return left + s * (right - left) / t[n] }
function sy(speed) { return (speed_top + speed_bottom) / 2 - speed * (speed_bottom - speed_top) / 52 }
function distance(ax, ay, bx, by) { return sqrt((ax - bx) ^ 2 + (ay - by) ^ 2) }

function text(at_x, at_y, words, more) {
  gsub(/&/, "\\&amp;", words); gsub(/</, "\\&lt;", words)
  printf "<text x=\"%.1f\" y=\"%.1f\" %s>%s</text>\n", at_x, at_y, more, words
}

function stroke(x1, y1, x2, y2, style) {
  printf "<path d=\"M%.1f %.1fL%.1f %.1f\" fill=\"none\" %s/>\n", x1, y1, x2, y2, style
}

function draw_plane(    mm) {
  printf "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"4\" fill=\"#f8fafc\"/>\n",
         left, top, width_mm * scale, height_mm * scale
  for (mm = 0; mm <= width_mm; mm += 20) {
    stroke(px(mm), py(0), px(mm), py(height_mm), "stroke=\"#e2e8f0\"")
    text(px(mm), py(0) + 18, mm, "text-anchor=\"middle\" fill=\"#64748b\"")
  }
  for (mm = 0; mm <= height_mm; mm += 20) {
    stroke(px(0), py(mm), px(width_mm), py(mm), "stroke=\"#e2e8f0\"")
    text(px(0) - 8, py(mm) + 4, mm, "text-anchor=\"end\" fill=\"#64748b\"")
  }
  text(px(width_mm) - 10, py(0) - 10, "x, mm", "text-anchor=\"end\" fill=\"#64748b\"")
  text(px(0) + 10, py(height_mm) + 20, "y, mm", "fill=\"#64748b\"")
}

# A curve through every third row, which is nearer than a pixel, and the last.
function draw_curve(of_x, of_y, style,    i) {
  printf "<path fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" %s d=\"", style
  for (i = 1; i <= n; i += (i + 3 > n && i < n) ? n - i : 3) {
    printf "%s%.1f %.1f", (i == 1 ? "M" : "L"), px(of_x[i]), py(of_y[i])
  }
  print "\"/>"
}

function draw_path(    l, from_x, from_y, i) {
  from_x = x[1]; from_y = y[1]
  for (l = 1; l <= lines; ++l) {
    if (!(l in corner_x)) continue
    stroke(px(from_x), py(from_y), px(corner_x[l]), py(corner_y[l]),
           "stroke=\"#94a3b8\" stroke-width=\"1.3\" stroke-dasharray=\"5 4\"")
    from_x = corner_x[l]; from_y = corner_y[l]
  }
  draw_curve(x, y, "stroke=\"#93c5fd\" stroke-width=\"6\"")
  draw_curve(mx, my, "stroke=\"#1e3a8a\" stroke-width=\"1.5\"")
  for (i = 1; i <= n; ++i) {
    if (t[i] < seconds - 1e-9) continue
    printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.6\" fill=\"#1e3a8a\"/>\n", px(mx[i]), py(my[i])
    ++seconds
  }
}

# The row of the reference nearest to the corner of line l, while the robot is about it: in that
# line, or in the one after it, where the corner is rounded.
function nearest_row(l,    i, d, least, row, entered, after) {
  least = 1e9
  for (i = 1; i <= n; ++i) {
    if (line[i] == l) entered = 1
    if (!entered) continue
    if (line[i] != l && after == "") after = line[i]
    if (line[i] != l && line[i] != after) break
    d = distance(x[i], y[i], corner_x[l], corner_y[l])
    if (d < least) { least = d; row = i }
  }
  return row
}

function draw_corners(    l, row, d, place, place_x, place_y, missed, order, by_order, places, above) {
  for (l = 1; l <= lines; ++l) {
    if (!(l in corner_x)) continue
    row = nearest_row(l)
    d = distance(x[row], y[row], corner_x[l], corner_y[l])
    stroke(px(corner_x[l]), py(corner_y[l]), px(x[row]), py(y[row]),
           "stroke=\"#dc2626\" stroke-width=\"1.3\"")
    place = corner_x[l] "," corner_y[l]
    missed[place] = missed[place] (missed[place] == "" ? "" : ", then ") \
                    (d < 0.05 ? "reached" : sprintf("missed by %.1f mm", d))
    place_x[place] = corner_x[l]; place_y[place] = corner_y[l]
    if (!(place in order)) { order[place] = ++places; by_order[places] = place }
  }
  for (l = 1; l <= places; ++l) {
    place = by_order[l]
    printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" fill=\"#ffffff\" stroke=\"#dc2626\"" \
           " stroke-width=\"1.6\"/>\n", px(place_x[place]), py(place_y[place])
    above = place_y[place] > height_mm / 2
    text(px(place_x[place]) + 12, py(place_y[place]) + (above ? -12 : 20),
         "(" place_x[place] ", " place_y[place] ")", "font-weight=\"600\"")
    text(px(place_x[place]) + 12, py(place_y[place]) + (above ? 4 : 36), missed[place],
         "fill=\"#dc2626\"")
  }
}

function draw_program(at_y,    l, words) {
  for (l = 1; l <= lines; ++l) {
    words = source[l]
    sub(/[ \t]*\/\/.*/, "", words)
    text(px(width_mm) + 46, at_y + 20 * l - 10, l, \
         "text-anchor=\"end\" fill=\"#94a3b8\" font-family=\"monospace\"")
    text(px(width_mm) + 56, at_y + 20 * l - 10, words, \
         "font-family=\"monospace\" font-size=\"13.5\" fill=\"#0f172a\"")
  }
}

function draw_key(at_y,    at_x) {
  at_x = px(width_mm) + 32
  stroke(at_x, at_y, at_x + 26, at_y, \
         "stroke=\"#94a3b8\" stroke-width=\"1.3\" stroke-dasharray=\"5 4\"")
  text(at_x + 36, at_y + 4, "programmed", "")
  stroke(at_x, at_y + 24, at_x + 26, at_y + 24, \
         "stroke=\"#93c5fd\" stroke-width=\"6\" stroke-linecap=\"round\"")
  text(at_x + 36, at_y + 28, "reference", "")
  stroke(at_x, at_y + 48, at_x + 26, at_y + 48, "stroke=\"#1e3a8a\" stroke-width=\"1.5\"")
  printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.6\" fill=\"#1e3a8a\"/>\n", at_x + 13, at_y + 48
  text(at_x + 36, at_y + 52, "measured, a dot", "")
  text(at_x + 36, at_y + 69, "each second;", "")
  text(at_x + 36, at_y + 86, sprintf("%.0f µm off at most", 1000 * worst_error), "")
}

# The share of time that each line owns: up to and with its last row.
function draw_lanes(    i, begin, lanes) {
  begin = 1
  for (i = 2; i <= n; ++i) {
    if (i < n && line[i + 1] == line[i]) continue
    printf "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>\n",
           tx(t[begin]), speed_top, tx(t[i]) - tx(t[begin]), speed_bottom - speed_top,
           (++lanes % 2 ? "#f8fafc" : "#eef2f7")
    text((tx(t[begin]) + tx(t[i])) / 2, speed_top - 8, "line " line[i], \
         "text-anchor=\"middle\" fill=\"#64748b\"")
    text(tx(t[begin]), speed_bottom + 18, sprintf("%.2f", t[begin]), \
         "text-anchor=\"middle\" fill=\"#64748b\"")
    begin = i
  }
  text(right, speed_bottom + 18, sprintf("%.2f s", t[n]), "text-anchor=\"middle\" font-weight=\"600\"")
}

function draw_speeds(    i, speed) {
  printf "<path fill=\"#dbeafe\" d=\"M%.1f %.1f", tx(t[1]), sy(0)
  for (i = 1; i <= n; i += 3) printf "L%.1f %.1f", tx(t[i]), sy(distance(vx[i], vy[i], 0, 0))
  printf "L%.1f %.1fZ\"/>\n", tx(t[n]), sy(0)
  for (speed = -v_max; speed <= v_max; speed += v_max) {
    stroke(left, sy(speed), right, sy(speed), \
           "stroke=\"#94a3b8\"" (speed ? " stroke-dasharray=\"3 4\"" : ""))
    text(left - 8, sy(speed) + 4, (speed < 0 ? "−" (-speed) : speed), "text-anchor=\"end\" fill=\"#64748b\"")
  }
  draw_rate(vx, "#2563eb")
  draw_rate(vy, "#ea580c")
  text(left, speed_top - 32, "speed, mm/s", "fill=\"#64748b\"")
  text(right - 330, speed_top - 32, "axis x", "fill=\"#2563eb\"")
  text(right - 275, speed_top - 32, "axis y", "fill=\"#ea580c\"")
  printf "<rect x=\"%.1f\" y=\"%.1f\" width=\"22\" height=\"11\" rx=\"2\" fill=\"#dbeafe\"/>\n",
         right - 220, speed_top - 42
  text(right - 192, speed_top - 32, "tool", "")
  stroke(right - 146, speed_top - 36, right - 120, speed_top - 36, \
         "stroke=\"#94a3b8\" stroke-dasharray=\"3 4\"")
  text(right - 112, speed_top - 32, "limit of each axis", "")
}

function draw_rate(rate, colour,    i) {
  printf "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.8\" d=\"", colour
  for (i = 1; i <= n; i += 3) {
    printf "%s%.1f %.1f", (i == 1 ? "M" : "L"), tx(t[i]), sy(rate[i])
  }
  print "\"/>"
}
