-- Nested loops over integers.
local sum = 0
for i = 1, 4000 do
  for j = 1, 4000 do
    sum = sum + i * j
  end
end
print(sum)
