-- Products of poses: a place and a quaternion each, in a table.
local function product(p, q)
  local w, i, j, k = p[4], p[5], p[6], p[7]
  local x, y, z = q[1], q[2], q[3]
  local tx, ty, tz = 2 * (j * z - k * y), 2 * (k * x - i * z), 2 * (i * y - j * x)
  local qw, qi, qj, qk = q[4], q[5], q[6], q[7]
  return {
    p[1] + x + w * tx + j * tz - k * ty,
    p[2] + y + w * ty + k * tx - i * tz,
    p[3] + z + w * tz + i * ty - j * tx,
    w * qw - i * qi - j * qj - k * qk,
    w * qi + i * qw + j * qk - k * qj,
    w * qj - i * qk + j * qw + k * qi,
    w * qk + i * qj - j * qi + k * qw
  }
end
local function turned(a, b, c)
  local ca, sa = math.cos(a / 2), math.sin(a / 2)
  local cb, sb = math.cos(b / 2), math.sin(b / 2)
  local cc, sc = math.cos(c / 2), math.sin(c / 2)
  return cc * cb * ca + sc * sb * sa, cc * cb * sa - sc * sb * ca,
    cc * sb * ca + sc * cb * sa, sc * cb * ca - cc * sb * sa
end
local p = {0, 0, 0, 1, 0, 0, 0}
local q = {0.001, 0.002, 0.003, turned(math.rad(10), math.rad(20), math.rad(30))}
for n = 1, 2000000 do p = product(p, q) end
print(math.floor(math.sqrt(p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2) + 0.5))
