#include "app/reports/second_order_notes.hpp"

#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

namespace forefront {

namespace {

/// Returns a note on the straight edges with one reason; nothing if there are none.
Diagnostics straightNote(const SecondOrderReport &order, StraightReason reason, const char *why, const char *advice) {
    constexpr std::size_t kShown = 5;
    std::size_t count = 0;
    std::string places;
    for (const StraightEdge &edge : order.straight) {
        if (edge.reason == reason && count++ < kShown) {
            places += (count == 1 ? ": at " : ", ") + placeText(edge.at);
        }
    }
    if (count == 0) {
        return {};
    }
    return {noteOf("straight-edge",
                   (count == 1 ? "1 edge along a curve is" : std::to_string(count) + " edges along curves are") +
                       (" straight, " + std::string(why)) + places +
                       (count > kShown ? " and more; --stats lists all" : ""),
                   advice)};
}

/// Returns a note on the elements whose Jacobian determinant varies much; nothing if there are none.
Diagnostics unevenElementNote(const SecondOrderReport &order) {
    if (order.uneven.empty()) {
        return {};
    }
    constexpr std::size_t kShown = 5;
    const std::size_t count = order.uneven.size();
    std::string places;
    for (const UnevenElement &element : std::span(order.uneven).first(std::min(count, kShown))) {
        places += (places.empty() ? ": " : ", ") + numberText(element.ratio, 3) + " at " + placeText(element.at);
    }
    return {noteOf("uneven-element",
                   "the Jacobian determinant falls below " + numberText(kReportedUniformity, 3) +
                       " of its maximum in " + (count == 1 ? "1 element" : std::to_string(count) + " elements") +
                       " of second order" + places + (count > kShown ? " and more; --stats lists all" : ""),
                   "choose smaller elements there, unless a sharp corner is the reason")};
}

} // namespace

Diagnostics secondOrderNotes(const SecondOrderReport &order) {
    constexpr const char *kSmaller = "choose smaller elements there to follow the curve";
    Diagnostics notes;
    for (const Diagnostics &part :
         {straightNote(order, StraightReason::Folded, "since an element would fold", kSmaller),
          straightNote(order, StraightReason::Meeting, "to stay clear of another edge across a gap", kSmaller),
          straightNote(order, StraightReason::Crossing, "where curves meet or come too close to follow",
                       "keep the curves apart there"),
          unevenElementNote(order)}) {
        notes.insert(notes.end(), part.begin(), part.end());
    }
    return notes;
}

} // namespace forefront
