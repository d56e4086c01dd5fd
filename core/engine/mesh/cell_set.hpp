#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/cell.hpp"

#include <cstdint>
#include <initializer_list>

namespace FOREFRONT_API forefront {

/// A set of kinds of cells.
class CellSet {
  public:
    constexpr CellSet() = default;
    constexpr CellSet(std::initializer_list<CellKind> kinds) {
        for (const CellKind kind : kinds) {
            add(kind);
        }
    }

    constexpr void add(CellKind kind) { bits_ = static_cast<std::uint16_t>(bits_ | bit(kind)); }
    constexpr bool has(CellKind kind) const { return (bits_ & bit(kind)) != 0; }
    /// Returns true if each kind in `other` is in this set.
    constexpr bool hasAll(CellSet other) const { return (other.bits_ & ~bits_) == 0; }
    constexpr bool empty() const { return bits_ == 0; }

    friend constexpr bool operator==(CellSet, CellSet) = default;

  private:
    static constexpr std::uint16_t bit(CellKind kind) {
        return static_cast<std::uint16_t>(1U << static_cast<unsigned>(kind));
    }

    std::uint16_t bits_ = 0;
};

/// All kinds of cells.
inline constexpr CellSet kAllCells = {CellKind::Point,          CellKind::Edge2,         CellKind::Edge3,
                                      CellKind::Triangle3,      CellKind::Triangle6,     CellKind::Quadrilateral4,
                                      CellKind::Quadrilateral8, CellKind::Quadrilateral9};

} // namespace forefront
