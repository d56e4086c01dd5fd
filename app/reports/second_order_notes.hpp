#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/second_order.hpp"

namespace forefront {

/// Returns notes on edges along curves that are straight and on elements whose Jacobian determinant varies much, with
/// their places; nothing if there are none.
Diagnostics secondOrderNotes(const SecondOrderReport &order);

} // namespace forefront
