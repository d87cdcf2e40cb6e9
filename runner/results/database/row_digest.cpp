#include "database/row_digest.h"

#include <algorithm>

#include "database/record_table.h"
#include "database/store_error.h"

namespace morula {
namespace {

std::vector<std::string> sortedColumns(Database& db, const std::string& table) {
  std::vector<std::string> names = columnNames(db, table);
  if (names.empty()) throw StoreError(db.file().string() + ": there is no table " + table + " in it");
  std::ranges::sort(names);
  return names;
}

std::string selectOf(const std::vector<std::string>& columns, const std::string& table, const std::string& where) {
  std::string list;
  for (const std::string& name : columns) list += (list.empty() ? "" : ", ") + sqlName(name);
  return "SELECT " + list + " FROM " + sqlName(table) + (where.empty() ? "" : " WHERE " + where);
}

}  // namespace

RowDigest& RowDigest::operator+=(const RowDigest& more) {
  rows += more.rows;
  const std::uint64_t low = sum.low + more.sum.low;
  sum.high += more.sum.high + (low < sum.low ? 1 : 0);
  sum.low = low;
  return *this;
}

RowDigester::RowDigester(Database& db, const std::string& table, const std::string& where)
    : names_(sortedColumns(db, table)), rows_(db, selectOf(names_, table, where)) {
  for (const std::string& name : names_) numbers_.push_back(hashOf(name).low);
}

Hash RowDigester::hashRow() {
  bytes_.clear();
  rows_.appendRow(bytes_, numbers_);
  return hashOf(bytes_);
}

RowDigest RowDigester::digest() {
  RowDigest digest;
  while (rows_.next()) digest += {1, hashRow()};
  return digest;
}

std::map<std::string, RowDigest> RowDigester::digestsBy(const std::string& column) {
  const auto place = std::ranges::find(names_, column) - names_.begin();
  std::map<std::string, RowDigest> digests;
  while (rows_.next()) digests[rows_.text(static_cast<int>(place))] += {1, hashRow()};
  return digests;
}

}  // namespace morula
