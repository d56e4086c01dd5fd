#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace forefront {

/// Assigns tags to names: equal names share a tag; tags that are given as numbers are kept free.
class TagAllocator {
  public:
    void reserve(std::int32_t tag) { taken_.insert(tag); }
    /// Returns the tag of a name. The empty name has a tag too, without an entry in names().
    std::int32_t of(const std::string &name);
    /// Returns the tag of a name if it has one.
    std::optional<std::int32_t> find(const std::string &name) const;
    const std::map<std::int32_t, std::string> &names() const { return names_; }
    void name(std::int32_t tag, const std::string &name) { names_.emplace(tag, name); }

  private:
    std::set<std::int32_t> taken_;
    std::map<std::string, std::int32_t> tags_;
    std::map<std::int32_t, std::string> names_;
};

} // namespace forefront
