-- Products of matrices of 60 x 60 floats: tables of tables.
local n <const> = 60
local a, b, c = {}, {}, {}
for i = 1, n do
  a[i], b[i], c[i] = {}, {}, {}
  for j = 1, n do
    a[i][j] = (i + j) / 16
    b[i][j] = (i - j) / 8
    c[i][j] = 0.0
  end
end
for round = 1, 10 do
  for i = 1, n do
    for j = 1, n do
      local sum = 0.0
      for k = 1, n do
        sum = sum + a[i][k] * b[k][j]
      end
      c[i][j] = sum
    end
  end
end
local trace = 0.0
for i = 1, n do
  trace = trace + c[i][i]
end
print(math.floor(trace + 0.5))
