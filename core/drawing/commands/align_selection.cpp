#include "core/drawing/commands/transform.hpp"
#include "core/drawing/formulas/shift_formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr std::uint32_t kWhole = 0xffffffffU;

/// A shape or a node to align or distribute.
struct Item {
    NodeRef what; ///< node kWhole: the whole shape
    Box2 box;
    Vec2 by; ///< its movement
};

/// Returns the selected shapes, or the selected nodes if there are none, in the order of their ids.
std::vector<Item> itemsOf(const Document &document, const Selection &selection) {
    std::vector<Item> items;
    for (const auto &shape : document.shapes) {
        if (selection.shapes.contains(shape->id)) {
            items.push_back({{shape->id, kWhole}, boundsOf(*shape), {}});
        }
        const std::vector<Vec2> handles = selection.shapes.empty() ? handlesOf(*shape) : std::vector<Vec2>();
        for (auto node = selection.nodes.lower_bound({shape->id, 0});
             node != selection.nodes.end() && node->shape == shape->id && node->node < handles.size(); ++node) {
            items.push_back({*node, {handles[node->node], handles[node->node]}, {}});
        }
    }
    std::sort(items.begin(), items.end(), [](const Item &a, const Item &b) { return a.what < b.what; });
    return items;
}

/// Moves the items of one shape.
void moveItems(Shape &shape, std::span<const Item> items) {
    if (items.front().what.node == kWhole) {
        moveShape(shape, items.front().by);
        return;
    }
    std::vector<Vec2> places = handlesOf(shape);
    for (const Item &item : items) {
        places[item.what.node] += item.by;
        if (!isPath(shape)) {
            placeHandle(shape, item.what.node, places[item.what.node]);
        }
    }
    if (isPath(shape)) {
        moveNodes(shape, std::move(places));
    }
}

/// Moves items, in one pass over the document.
Result<Document> moveEach(const Document &document, std::vector<Item> items) {
    std::sort(items.begin(), items.end(), [](const Item &a, const Item &b) { return a.what < b.what; });
    const auto before = [](const Item &item, std::uint32_t id) { return item.what.shape < id; };
    Document next = document;
    for (auto &pointer : next.shapes) {
        const auto first = std::lower_bound(items.begin(), items.end(), pointer->id, before);
        const auto last = std::lower_bound(first, items.end(), pointer->id + 1, before);
        if (first != last) {
            Shape shape = *pointer;
            moveItems(shape, {first, last});
            if (Diagnostics faults = checkShape(shape); !faults.empty()) {
                return faults;
            }
            pointer = std::make_shared<const Shape>(std::move(shape));
            if (first->what.node == kWhole) {
                shiftFormulas(next, NumberOwner::ofShape(pointer->id), first->by);
            }
        }
    }
    return next;
}

/// Returns the movement that aligns a box to another one.
Vec2 aligning(const Box2 &box, const Box2 &all, Alignment alignment) {
    switch (alignment) {
    case Alignment::Left:
        return {all.min.x - box.min.x, 0.0};
    case Alignment::CentreX:
        return {all.centre().x - box.centre().x, 0.0};
    case Alignment::Right:
        return {all.max.x - box.max.x, 0.0};
    case Alignment::Bottom:
        return {0.0, all.min.y - box.min.y};
    case Alignment::CentreY:
        return {0.0, all.centre().y - box.centre().y};
    case Alignment::Top:
        break;
    }
    return {0.0, all.max.y - box.max.y};
}

Diagnostics tooFew(const char *command, const char *count, std::size_t found) {
    return error("not-possible",
                 std::string(command) + " needs " + count + " shapes or nodes; selected: " + std::to_string(found),
                 "select more of them, with Shift or a box");
}

} // namespace

std::size_t alignableItems(const Selection &selection) {
    return selection.shapes.empty() ? selection.nodes.size() : selection.shapes.size();
}

Result<Document> alignSelection(const Document &document, const Selection &selection, Alignment alignment) {
    std::vector<Item> items = itemsOf(document, selection);
    if (items.size() < 2) {
        return tooFew("align", "at least two", items.size());
    }
    Box2 all;
    for (const Item &item : items) {
        all.add(item.box);
    }
    for (Item &item : items) {
        item.by = aligning(item.box, all, alignment);
    }
    return moveEach(document, std::move(items));
}

Result<Document> distributeSelection(const Document &document, const Selection &selection, bool alongX) {
    std::vector<Item> items = itemsOf(document, selection);
    if (items.size() < 3) {
        return tooFew("distribute", "at least three", items.size());
    }
    const auto low = [&](const Item &item) { return alongX ? item.box.min.x : item.box.min.y; };
    const auto size = [&](const Item &item) { return alongX ? item.box.size().x : item.box.size().y; };
    std::stable_sort(items.begin(), items.end(),
                     [&](const Item &a, const Item &b) { return low(a) + 0.5 * size(a) < low(b) + 0.5 * size(b); });
    double room = low(items.back()) - low(items.front());
    for (std::size_t k = 0; k + 1 < items.size(); ++k) {
        room -= size(items[k]);
    }
    const double gap = room / static_cast<double>(items.size() - 1);
    double place = low(items.front());
    for (std::size_t k = 0; k + 1 < items.size(); ++k) {
        const double by = place - low(items[k]);
        items[k].by = alongX ? Vec2{by, 0.0} : Vec2{0.0, by};
        place += size(items[k]) + gap;
    }
    return moveEach(document, std::move(items));
}

} // namespace forefront
