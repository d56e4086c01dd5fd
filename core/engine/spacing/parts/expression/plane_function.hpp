#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/vec2.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace forefront {

struct Domain;
class InsideTest;
struct ValueRange;

/// A function of the position that a formula calls by name, such as a raster or the distance to the shore. Finite
/// everywhere. Immutable, so threads may share it.
class PlaneFunction {
  public:
    PlaneFunction() = default;
    PlaneFunction(const PlaneFunction &) = delete;
    PlaneFunction &operator=(const PlaneFunction &) = delete;
    virtual ~PlaneFunction() = default;

    virtual double at(Vec2 p) const = 0;
    /// Returns bounds of the values over a box.
    virtual ValueRange range(const Box2 &box) const = 0;
    /// Returns the fault of the first place of the domain where the function has no data; empty if there is none.
    /// `inside` is null if the inside is unknown; then only the domain's nodes are checked.
    virtual Diagnostics gaps(const Domain &domain, const InsideTest *inside) const = 0;
};

/// The functions of the position that a formula may call.
class FormulaFunctions {
  public:
    FormulaFunctions() = default;
    FormulaFunctions(const FormulaFunctions &) = delete;
    FormulaFunctions &operator=(const FormulaFunctions &) = delete;
    virtual ~FormulaFunctions() = default;

    /// Returns the function with a name; null if there is none.
    virtual std::shared_ptr<const PlaneFunction> find(std::string_view name) const = 0;
    /// Returns the names that find() knows, separated by commas.
    virtual std::string names() const = 0;
    /// Returns the distance to the boundary parts with the given names, to the whole boundary without any; the message
    /// of the fault if a name is unknown.
    virtual std::variant<std::shared_ptr<const PlaneFunction>, std::string>
    shore(std::span<const std::string> parts) const = 0;
};

} // namespace forefront
