-- The primes up to 100000, ten times: an array, read and written.
local n <const> = 100000
local composite = {}
local count = 0
for round = 1, 10 do
  for i = 1, n do
    composite[i] = false
  end
  count = 0
  for i = 2, n do
    if not composite[i] then
      count = count + 1
      for k = 2 * i, n, i do
        composite[k] = true
      end
    end
  end
end
print(count)
