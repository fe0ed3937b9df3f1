// SPDX-License-Identifier: MPL-2.0
// diameter = "5 um", or a table that says how diameters are distributed.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "config/sizes.hpp"
#include "config/value.hpp"

namespace porefines::config {
namespace {

constexpr Range diameters{0, 1, true};  // [m]
constexpr auto example = R"({ mean = "5 um", standard_deviation = "0.5 um" })";
constexpr auto table_example =
    R"({ distribution = "table", diameters = ["4 um", "5 um"], shares = [0.3, 0.7] })";

const std::vector<std::string>& law_names() {
  static const std::vector<std::string> names{"mono", "normal", "lognormal", "table"};
  return names;
}

Real read_length(const Node& table, const std::string& name, Real absent) {
  const Node* node = find(table, name);
  return node == nullptr ? absent : read_quantity(*node, kind::length, diameters);
}

SizeLaw read_law(const Node& table) {
  if (const Node* word = find(table, "distribution")) {
    return static_cast<SizeLaw>(read_choice(*word, law_names()));
  }
  return find(table, "diameters") != nullptr            ? SizeLaw::table
         : find(table, "standard_deviation") != nullptr ? SizeLaw::normal
                                                        : SizeLaw::mono;
}

void refuse_all_but(const Node& table, SizeLaw law, const std::vector<std::string>& wanted) {
  for (const Entry& entry : std::get<Table>(table.value)) {
    if (std::find(wanted.begin(), wanted.end(), entry.name) == wanted.end()) {
      fail(entry.node.place, fmt::format("has no meaning for distribution = \"{}\"",
                                         law_names()[static_cast<std::size_t>(law)]));
    }
  }
}

void read_shares(Sizes& sizes, const Node& table) {
  const Node* lengths = find(table, "diameters");
  const Node* shares = find(table, "shares");
  if (lengths == nullptr || shares == nullptr) {
    fail(table.place, "needs both diameters and shares", table_example);
  }
  for (const Node& node : read_list(*lengths, "[\"4 um\", \"5 um\"]")) {
    sizes.diameters.push_back(read_quantity(node, kind::length, diameters));
  }
  for (const Node& node : read_list(*shares, "[0.3, 0.7]")) {
    sizes.shares.push_back(read_quantity(node, kind::number, not_negative));
  }
  if (sizes.diameters.size() != sizes.shares.size() || sizes.shares.empty()) {
    fail(
        shares->place,
        fmt::format("has {} numbers for {} diameters", sizes.shares.size(), sizes.diameters.size()),
        "one share for each diameter");
  }
  const Real sum = std::accumulate(sizes.shares.begin(), sizes.shares.end(), Real{0});
  if (!(std::abs(sum - 1) < 1e-6)) {
    fail(shares->place, fmt::format("add up to {:.6g}, not to 1", sum));
  }
}

/// Cuts at three standard deviations, of the logarithm where that is what is normal.
void fill_cuts(Sizes& sizes) {
  if (sizes.law == SizeLaw::normal) {
    sizes.smallest = std::max(sizes.mean - 3 * sizes.deviation, sizes.mean / 10);
    sizes.largest = sizes.mean + 3 * sizes.deviation;
  } else {
    const Real variance = std::log1p(std::pow(sizes.deviation / sizes.mean, 2));
    const Real middle = sizes.mean * std::exp(-variance / 2);
    sizes.smallest = middle * std::exp(-3 * std::sqrt(variance));
    sizes.largest = middle * std::exp(3 * std::sqrt(variance));
  }
}

void read_spread(Sizes& sizes, const Node& table) {
  sizes.deviation = read_length(table, "standard_deviation", 0);
  if (!(sizes.deviation > 0)) {
    fail(table.place, "needs a standard_deviation", example);
  }
  fill_cuts(sizes);
  sizes.smallest = read_length(table, "smallest", sizes.smallest);
  sizes.largest = read_length(table, "largest", sizes.largest);
  if (!(sizes.smallest < sizes.mean && sizes.mean < sizes.largest)) {
    fail(
        table.place,
        fmt::format("the mean of {:.6g} m is not between smallest, {:.6g} m, and largest, {:.6g} m",
                    sizes.mean, sizes.smallest, sizes.largest));
  }
}

}  // namespace

Sizes read_sizes(const Node& node) {
  Sizes sizes;
  if (!std::holds_alternative<Table>(node.value)) {
    sizes.mean = read_quantity(node, kind::length, diameters);
    return sizes;
  }
  (void)read_table(node, {"mean", "standard_deviation", "distribution", "smallest", "largest", "by",
                          "diameters", "shares"});
  sizes.law = read_law(node);
  if (const Node* by = find(node, "by")) {
    sizes.by_volume = read_choice(*by, {"number", "volume"}) == 1;
  }
  if (sizes.law == SizeLaw::table) {
    refuse_all_but(node, sizes.law, {"distribution", "by", "diameters", "shares"});
    read_shares(sizes, node);
    return sizes;
  }
  sizes.mean = read_length(node, "mean", 0);
  if (!(sizes.mean > 0)) {
    fail(node.place, "needs a mean", example);
  }
  if (sizes.law == SizeLaw::mono) {
    refuse_all_but(node, sizes.law, {"distribution", "by", "mean"});
  } else {
    refuse_all_but(node, sizes.law,
                   {"distribution", "by", "mean", "standard_deviation", "smallest", "largest"});
    read_spread(sizes, node);
  }
  return sizes;
}

std::string write_sizes(const Sizes& sizes) {
  const auto length = [](Real value) { return toml_quantity(value, kind::length); };
  if (sizes.law == SizeLaw::mono) {
    return sizes.mean > 0 ? length(sizes.mean) : "";
  }
  const std::string head = fmt::format("{{ distribution = \"{}\", by = \"{}\"",
                                       law_names()[static_cast<std::size_t>(sizes.law)],
                                       sizes.by_volume ? "volume" : "number");
  if (sizes.law != SizeLaw::table) {
    return fmt::format("{}, mean = {}, standard_deviation = {}, smallest = {}, largest = {} }}",
                       head, length(sizes.mean), length(sizes.deviation), length(sizes.smallest),
                       length(sizes.largest));
  }
  std::string lengths;
  std::string shares;
  for (std::size_t i = 0; i < sizes.shares.size(); ++i) {
    lengths += (i > 0 ? ", " : "") + length(sizes.diameters[i]);
    shares += fmt::format("{}{}", i > 0 ? ", " : "", sizes.shares[i]);
  }
  return fmt::format("{}, diameters = [{}], shares = [{}] }}", head, lengths, shares);
}

}  // namespace porefines::config
