#pragma once

#include "core/files/json/json.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

/// Finds the names of a map's features in their properties: in a given property, or else in "name", "Name" or "NAME".
/// If no feature has one of the latter, the names are "NAME_n" of administrative areas (as in files of gadm.org), with
/// the highest level n that all features with such names have: one level for all, so that no area is named after a
/// larger one. If the given property is "id", the member "id" of a feature stands in for it where the property is
/// missing or empty.
class FeatureNames {
  public:
    /// `key`: the property to take names from; absent: by the rule above.
    explicit FeatureNames(std::optional<std::string> key) : key_(std::move(key)) {}

    /// Collects the properties of a feature that can name it. Call this for all features before naming any.
    void survey(const JsonValue &feature);

    /// Returns the name of a feature; empty if it has none.
    std::string nameOf(const JsonValue &feature) const;
    /// Returns true if names can come from this property.
    bool uses(std::string_view key) const;
    /// Returns the property to name in messages.
    std::string source() const;

    /// Returns the properties with text or a number in at least one feature.
    std::vector<std::string> keys() const;
    /// Returns false if a property is given that no feature has.
    bool found() const { return !key_ || keys_.contains(*key_); }
    /// Returns true if the rule is used and a property holds text.
    bool offersText() const;

  private:
    void surveyProperties(const JsonValue &properties);
    /// Returns "NAME_n" of the rule above.
    std::optional<std::string> levelKey() const;

    std::optional<std::string> key_;
    std::map<std::string, bool> keys_; ///< those with text or a number, and whether they hold text
    unsigned levels_ = ~0U;            ///< bit n: all features with a "NAME_..." so far have "NAME_n"
    bool levelled_ = false;            ///< a feature has such a name
    bool named_ = false;               ///< a feature has a "name", "Name" or "NAME"
};

} // namespace forefront
