-- Fields of tables: bodies in an array move, and bounce off walls.
local n <const> = 50
local bodies = {}
local total = 0

for i = 1, n do
  bodies[i] = {x = i + 0.0, y = n - i + 0.0, vx = i / 8, vy = 3 - i / 16, bounces = 0}
end
for step = 1, 8000 do
  for i = 1, n do
    bodies[i].x = bodies[i].x + bodies[i].vx
    bodies[i].y = bodies[i].y + bodies[i].vy
    if bodies[i].x < 0 or bodies[i].x > 100 then
      bodies[i].vx = -bodies[i].vx
      bodies[i].bounces = bodies[i].bounces + 1
    end
    if bodies[i].y < 0 or bodies[i].y > 100 then
      bodies[i].vy = -bodies[i].vy
      bodies[i].bounces = bodies[i].bounces + 1
    end
  end
end
for i = 1, n do
  total = total + bodies[i].bounces
end
print(total)
