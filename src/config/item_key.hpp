// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "config/key.hpp"

/// Tables that may repeat, such as [[particles]]: their keys are listed like all others, and are
/// read, written and documented from that list.
namespace porefines::config {

/// One key of an item. As Key; the Case is there for the folder that paths start from.
template <typename Item>
struct ItemKey {
  std::string name;
  std::string type;
  std::string doc;
  std::function<void(Item&, const Node&, const Case&)> read;
  std::function<std::string(const Item&)> write;  ///< the TOML value; "" when absent
  std::string absent = "";                        ///< what leaving it out means
};

template <typename Item>
std::string write_item(const Item& item, const std::vector<ItemKey<Item>>& keys) {
  std::string text;
  for (const ItemKey<Item>& key : keys) {
    const std::string value = key.write(item);
    if (!value.empty()) {
      text += (text.empty() ? "" : ", ") + key.name + " = " + value;
    }
  }
  return "{ " + text + " }";
}

/// A list of tables as one key; a single [table] counts as a list of one.
template <typename Item>
Key list_key(const std::string& path, std::vector<Item> Case::*member,
             const std::vector<ItemKey<Item>>& keys, const std::string& doc) {
  std::vector<std::string> names;
  std::vector<ItemLine> lines;
  for (const ItemKey<Item>& key : keys) {
    names.push_back(key.name);
    const std::string value = key.write(Item{});
    lines.push_back({key.name, key.type, value.empty() ? key.absent : "`" + value + "`", key.doc});
  }
  const auto read_item = [=](const Node& element, const Case& c) {
    (void)read_table(element, names);
    Item item;
    for (const ItemKey<Item>& key : keys) {
      if (const Node* node = find(element, key.name)) {
        key.read(item, *node, c);
      }
    }
    return item;
  };
  const auto read = [=](Case& c, const Node& node) {
    std::vector<Item> items;
    if (std::holds_alternative<Table>(node.value)) {
      items.push_back(read_item(node, c));
    } else {
      for (const Node& element : read_list(node, "[[" + path + "]]")) {
        items.push_back(read_item(element, c));
      }
    }
    c.*member = items;
  };
  const auto write = [=](const Case& c) -> std::string {
    std::string list;
    for (const Item& item : c.*member) {
      list += (list.empty() ? "" : ", ") + write_item(item, keys);
    }
    return list.empty() && (Case{}.*member).empty() ? "" : "[" + list + "]";
  };
  return {path, "list of tables", doc, read, write, "none", {}, lines};
}

/// A key that is only written where it has a meaning.
template <typename Item, typename Predicate>
ItemKey<Item> only_where(const Predicate& meant, ItemKey<Item> key) {
  const std::string value = key.write(Item{});
  key.absent = value.empty() ? key.absent : "`" + value + "`";
  key.write = [=, write = key.write](const Item& item) {
    return meant(item) ? write(item) : std::string();
  };
  return key;
}

/// The node of one item, whether it stands in a list or alone.
[[nodiscard]] const Node& item_node(const Node& given, const std::string& path, std::size_t index);

/// ["1 m", "2 m", "3 m"]
[[nodiscard]] Triple read_triple(const Node& node, const QuantityKind& wanted, Range range = {});
[[nodiscard]] std::string write_triple(const Triple& value, const QuantityKind& quantity_kind);
/// An absolute path; in a file it starts at the folder of the case, on the command line where the
/// user is.
[[nodiscard]] std::string read_path(const Node& node, const Case& c);
/// { low = [...], high = [...] }
[[nodiscard]] Region read_region(const Node& node);
[[nodiscard]] std::string write_region(const std::optional<Region>& region);

// How the common kinds are made.

template <typename Item>
ItemKey<Item> text_item(const std::string& name, std::string Item::*member,
                        const std::string& absent, const std::string& doc) {
  return {name,
          "text",
          doc,
          [=](Item& item, const Node& node, const Case&) { item.*member = read_text(node); },
          [=](const Item& item) { return (item.*member).empty() ? "" : toml_string(item.*member); },
          absent};
}

template <typename Item>
ItemKey<Item> path_item(const std::string& name, std::string Item::*member,
                        const std::string& absent, const std::string& doc) {
  ItemKey<Item> key = text_item(name, member, absent, doc);
  key.read = [=](Item& item, const Node& node, const Case& c) {
    item.*member = read_path(node, c);
  };
  return key;
}

template <typename Item>
ItemKey<Item> flag_item(const std::string& name, bool Item::*member, const std::string& doc) {
  return {name, "true or false", doc,
          [=](Item& item, const Node& node, const Case&) { item.*member = read_flag(node); },
          [=](const Item& item) { return std::string(item.*member ? "true" : "false"); }};
}

/// A value outside of its range means absent.
template <typename Item>
ItemKey<Item> quantity_item(const std::string& name, Real Item::*member, const QuantityKind& wanted,
                            Range range, const std::string& absent, const std::string& doc) {
  const std::string type = wanted.si_unit.empty() ? "number, " + range.text()
                                                  : std::string(wanted.name) + ", e.g. `\"" +
                                                        std::string(wanted.example) + "\"`";
  return {name,
          type,
          doc,
          [=](Item& item, const Node& node, const Case&) {
            item.*member = read_quantity(node, wanted, range);
          },
          [=](const Item& item) {
            const Real value = item.*member;
            return range.contains(value) ? toml_quantity(value, wanted) : std::string();
          },
          absent};
}

template <typename Item>
ItemKey<Item> integer_item(const std::string& name, int Item::*member, Range range,
                           const std::string& doc) {
  return {name, "whole number, " + range.text(), doc,
          [=](Item& item, const Node& node, const Case&) {
            item.*member = static_cast<int>(read_integer(node, range));
          },
          [=](const Item& item) { return std::to_string(item.*member); }};
}

template <typename Item, typename Enum>
ItemKey<Item> choice_item(const std::string& name, Enum Item::*member,
                          const std::vector<std::string>& names, const std::string& doc) {
  std::string type;
  for (const std::string& word : names) {
    type += (type.empty() ? "`" : ", `") + toml_string(word) + "`";
  }
  return {
      name, type, doc,
      [=](Item& item, const Node& node, const Case&) {
        item.*member = static_cast<Enum>(read_choice(node, names));
      },
      [=](const Item& item) { return toml_string(names[static_cast<std::size_t>(item.*member)]); }};
}

template <typename Item>
ItemKey<Item> triple_item(const std::string& name, Triple Item::*member, const QuantityKind& wanted,
                          const std::string& doc) {
  const std::string type =
      wanted.si_unit.empty() ? "three numbers" : "three of: " + std::string(wanted.name);
  return {
      name, type, doc,
      [=](Item& item, const Node& node, const Case&) { item.*member = read_triple(node, wanted); },
      [=](const Item& item) { return write_triple(item.*member, wanted); }};
}

template <typename Item>
ItemKey<Item> region_item(const std::string& name, std::optional<Region> Item::*member,
                          const std::string& absent, const std::string& doc) {
  return {name,
          "`{ low = [x, y, z], high = [x, y, z] }`",
          doc,
          [=](Item& item, const Node& node, const Case&) { item.*member = read_region(node); },
          [=](const Item& item) { return write_region(item.*member); },
          absent};
}

}  // namespace porefines::config
