#include "core/files/gmsh/msh_file.hpp"
#include "core/files/text/byte_scanner.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

constexpr std::int64_t kAnyTag = std::numeric_limits<std::int64_t>::max();

} // namespace

bool MshFile::readDataHeader(MshValues &field, std::size_t &count, std::int64_t &components) {
    std::size_t strings = 0, reals = 0, integers = 0;
    std::string_view text;
    double number = 0.0;
    if (!scanner_.count(strings, 2, {"the number of string tags"})) {
        return false;
    }
    for (std::size_t k = 0; k < strings; ++k) {
        if (!scanner_.quotedWord(text, {"a string tag"})) {
            return false;
        }
        field.name = k == 0 ? std::string(text) : field.name;
    }
    if (!scanner_.count(reals, 2, {"the number of real tags"})) {
        return false;
    }
    for (std::size_t k = 0; k < reals; ++k) {
        if (!scanner_.real(number, {"a real tag"})) {
            return false;
        }
    }
    if (!scanner_.count(integers, 2, {"the number of integer tags"})) {
        return false;
    }
    std::int64_t tag = 0;
    for (std::size_t k = 0; k < integers; ++k) {
        if (k == 2) {
            if (!scanner_.count(count, 4, {"the number of values"})) {
                return false;
            }
        } else if (!scanner_.integer(tag, 0, kAnyTag, {"an integer tag"})) {
            return false;
        }
        components = k == 1 ? tag : components;
    }
    return true;
}

bool MshFile::readData(bool ofNodes) {
    MshValues field;
    field.offset = scanner_.offset();
    std::size_t count = 0;
    std::int64_t components = 1;
    if (!readDataHeader(field, count, components)) {
        return false;
    }
    if (components != 1) {
        scanner_.source().note("vector-values",
                               "the field '" + field.name + "' is ignored: it has " + std::to_string(components) +
                                   " components; only fields with one component are read",
                               field.offset);
        const std::size_t end =
            scanner_.source().text.find(ofNodes ? "\n$EndNodeData" : "\n$EndElementData", scanner_.offset());
        scanner_.seek(end == std::string_view::npos ? scanner_.source().text.size() : end);
        return true;
    }
    field.values.assign(ofNodes ? builder_.mesh.nodes.size() : builder_.elements.size(),
                        std::numeric_limits<double>::quiet_NaN());
    if (binary_) {
        if (!readValuesBinary(ofNodes, count, field)) {
            return false;
        }
    } else {
        for (std::size_t k = 1; k <= count; ++k) {
            if (!readValue(ofNodes, k, field)) {
                return false;
            }
        }
    }
    (ofNodes ? values_ : elementValues_).push_back(std::move(field));
    return true;
}

bool MshFile::findElement(std::int64_t number, std::size_t &element) {
    if (elementTable_.size() == 0) {
        elementTable_.reserve(elementNumbers_.size());
        for (const std::int64_t known : elementNumbers_) {
            elementTable_.add(known);
        }
        elementTable_.finish();
    }
    element = elementTable_.find(number);
    return element != kNoIndex;
}

/// Reads the number of a node or element and its value. Those of lines and points are left out.
bool MshFile::readValue(bool ofNodes, std::size_t k, MshValues &field) {
    const Expect expect{ofNodes ? "nodal value" : "value of an element", k};
    NodeId node = kNoNode;
    std::int64_t number = 0;
    double value = 0.0;
    if (ofNodes ? !builder_.readNodeId(scanner_, node, expect) : !scanner_.integer(number, 0, kAnyTag, expect)) {
        return false;
    }
    const std::size_t place = scanner_.offset() + 1;
    if (!scanner_.real(value, expect)) {
        return false;
    }
    std::size_t item = index(node);
    if (ofNodes || findElement(number, item)) {
        field.set(item, value, place);
    }
    return true;
}

/// Reads the values of a section: four-byte numbers of nodes or elements, each followed by its value.
bool MshFile::readValuesBinary(bool ofNodes, std::size_t count, MshValues &field) {
    ByteScanner bytes(scanner_);
    for (std::size_t k = 1; k <= count; ++k) {
        const Expect expect{ofNodes ? "nodal value" : "value of an element", k};
        const std::size_t place = bytes.offset();
        std::int32_t number = 0;
        double value = 0.0;
        NodeId node = kNoNode;
        if (!scanner_.proceed(place) || !bytes.number(number, expect) || !bytes.number(value, expect) ||
            (ofNodes && !findNode(number, node, place))) {
            return false;
        }
        const std::size_t valuePlace = place + sizeof number;
        if (!std::isfinite(value)) {
            return bytes.fail(valuePlace, "non-finite", expect.words() + " must be finite");
        }
        std::size_t item = index(node);
        if (ofNodes || findElement(number, item)) {
            field.set(item, value, valuePlace);
        }
    }
    return true;
}

} // namespace forefront
