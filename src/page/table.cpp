// SPDX-License-Identifier: MPL-2.0
#include "page/table.hpp"

#include <algorithm>
#include <vector>

#include "core/json.hpp"
#include "page/pack.hpp"

namespace porefines::page {

std::string columns_json(const io::TextTable& table, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (table.rows.size() + most - 1) / most);
  Json columns;
  for (const std::string& name : table.names) {
    const std::vector<Real> all = table.numbers(name);
    std::vector<Real> kept;
    for (std::size_t row = (all.size() + step - 1) % step; row < all.size(); row += step) {
      kept.push_back(all[row]);
    }
    columns.set_json(name, json_numbers(kept));
  }
  Json out;
  out.set("rows", table.rows.size());
  out.set_json("columns", columns.text());
  return out.text();
}

}  // namespace porefines::page
