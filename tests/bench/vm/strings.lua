-- Texts: numbers written, joined, measured, cut, compared and searched.
local total = 0
local same = 0
for round = 1, 200 do
  local line = ""
  for i = 1, 200 do
    line = line .. tostring(i)
    line = line .. ","
  end
  for i = 1, 200 do
    local part = string.sub(line, i, i + 2)
    if part == "1,2" then same = same + 1 end
    total = total + (string.find(part, ",", 1, true) or 0) + #part
  end
  total = total + #line
end
print(total)
print(same)
