#include "core/drawing/shapes/groups.hpp"

#include <algorithm>
#include <memory>

namespace forefront {

namespace {

/// Returns a document whose shapes have the groups that `groupFor(shape)` returns.
template <class GroupFor>
Document withGroups(const Document &document, GroupFor groupFor) {
    Document next = document;
    for (std::shared_ptr<const Shape> &shape : next.shapes) {
        if (const std::uint32_t group = groupFor(*shape); group != shape->group) {
            auto changed = std::make_shared<Shape>(*shape);
            changed->group = group;
            shape = std::move(changed);
        }
    }
    return next;
}

/// Returns the groups of shapes.
std::set<std::uint32_t> groupsOf(const Document &document, const std::set<std::uint32_t> &shapes) {
    std::set<std::uint32_t> groups;
    for (const auto &shape : document.shapes) {
        if (shape->group != 0 && shapes.contains(shape->id)) {
            groups.insert(shape->group);
        }
    }
    return groups;
}

bool isSelectable(const Shape &shape) {
    return !shape.hidden && !shape.locked;
}

} // namespace

Result<Document> groupShapes(const Document &document, const std::set<std::uint32_t> &shapes) {
    const auto count = std::count_if(document.shapes.begin(), document.shapes.end(),
                                     [&](const auto &shape) { return shapes.contains(shape->id); });
    if (count < 2) {
        return error("not-possible", "a group needs at least two shapes", "select the shapes to group");
    }
    const std::set<std::uint32_t> dissolved = groupsOf(document, shapes);
    const std::uint32_t group = CopiedGroups(document)(1);
    return withGroups(document, [&](const Shape &shape) {
        return shapes.contains(shape.id) || dissolved.contains(shape.group) ? group : shape.group;
    });
}

Result<Document> ungroupShapes(const Document &document, const std::set<std::uint32_t> &shapes) {
    const std::set<std::uint32_t> dissolved = groupsOf(document, shapes);
    if (dissolved.empty()) {
        return error("not-possible", "none of the selected shapes is in a group", "select a shape of the group");
    }
    return withGroups(document, [&](const Shape &shape) { return dissolved.contains(shape.group) ? 0U : shape.group; });
}

std::set<std::uint32_t> shapesGroupedWith(const Document &document, std::uint32_t shape) {
    std::set<std::uint32_t> together{shape};
    const Shape *const found = findShape(document, shape);
    if (found != nullptr && found->group != 0) {
        for (const auto &other : document.shapes) {
            if (other->group == found->group && isSelectable(*other)) {
                together.insert(other->id);
            }
        }
    }
    return together;
}

void completeGroups(const Document &document, Selection &selection) {
    const std::set<std::uint32_t> groups = groupsOf(document, selection.shapes);
    if (groups.empty()) {
        return;
    }
    for (const auto &shape : document.shapes) {
        if (groups.contains(shape->group) && isSelectable(*shape)) {
            selection.shapes.insert(shape->id);
        }
    }
}

CopiedGroups::CopiedGroups(const Document &into) {
    for (const auto &shape : into.shapes) {
        next_ = std::max(next_, shape->group + 1);
    }
}

std::uint32_t CopiedGroups::operator()(std::uint32_t original) {
    if (original == 0) {
        return 0;
    }
    const auto [found, fresh] = numbers_.try_emplace(original, next_);
    next_ += fresh ? 1 : 0;
    return found->second;
}

} // namespace forefront
