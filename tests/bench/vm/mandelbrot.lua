-- How many points of a grid belong to the Mandelbrot set, as far as 200 steps tell.
local inside = 0
for row = 0, 199 do
  local ci = row / 100 - 1
  for column = 0, 199 do
    local cr = column / 100 - 1.5
    local zr, zi = 0.0, 0.0
    local steps = 0
    while steps < 200 and zr * zr + zi * zi <= 4.0 do
      local following = zr * zr - zi * zi + cr
      zi = 2.0 * zr * zi + ci
      zr = following
      steps = steps + 1
    end
    if steps == 200 then
      inside = inside + 1
    end
  end
end
print(inside)
