#include "core/drawing_files/dxf/dxf_file.hpp"

#include "core/drawing_files/dxf/dxf_groups.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/text/text_scanner.hpp"

#include <charconv>
#include <utility>

namespace forefront {

namespace {

int integerOf(std::string_view text, int otherwise) {
    int value = otherwise;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

class DxfFileReader {
  public:
    explicit DxfFileReader(const SourceText &source) : source_(source), groups_(source) {}

    Result<DxfFile> read() {
        readEncoding();
        bool ended = false;
        while (!ended && next()) {
            if (group_.code == 999) { // a comment
                continue;
            }
            if (group_.code != 0 || (group_.value != "SECTION" && group_.value != "EOF")) {
                groups_.fail(group_.offset, "bad-syntax",
                             "expected a SECTION or EOF, found group " + std::to_string(group_.code) + " with " +
                                 inQuotes(group_.value));
                break;
            }
            ended = group_.value == "EOF";
            if (!ended && !section()) {
                break;
            }
        }
        if (groups_.ok() && !ended) {
            source_.warn("dxf-end", "the end mark EOF is missing: the file may have been cut short",
                         source_.text.size());
        }
        return groups_.ok() ? Result<DxfFile>(std::move(file_)) : groups_.faults();
    }

  private:
    bool next() { return groups_.next(group_); }

    /// Reads the variables on which the texts of all sections depend.
    void readEncoding() {
        DxfGroups groups(source_);
        DxfGroup group;
        std::string_view variable;
        while (groups.next(group) && !(group.code == 0 && group.value == "ENDSEC")) {
            if (group.code == 9) {
                variable = group.value;
            } else if (variable == "$ACADVER" && group.code == 1) {
                file_.encoding.utf8 = group.value >= "AC1021";
            } else if (variable == "$DWGCODEPAGE" && group.code == 3) {
                file_.encoding.codepage = group.value;
            } else if (variable == "$INSUNITS" && group.code == 70) {
                file_.units = integerOf(group.value, 0);
                file_.unitsOffset = group.offset;
            }
        }
    }

    bool section() {
        const std::size_t place = group_.offset;
        if (!next() || group_.code != 2) {
            return groups_.fail(place, "bad-syntax", "expected the name of a section (group 2)");
        }
        name_ = group_.value;
        place_ = place;
        if (name_ == "TABLES") {
            return tables();
        }
        if (name_ == "BLOCKS") {
            return blocks();
        }
        if (name_ == "ENTITIES") {
            return step() && entities(file_.entities);
        }
        while (step()) {
            if (group_.code == 0 && group_.value == "ENDSEC") {
                return true;
            }
        }
        return false;
    }

    /// Reads a group within a section, which must not end with the file.
    bool step() {
        if (next()) {
            return true;
        }
        return groups_.fail(place_, "bad-syntax", "the section " + inQuotes(name_) + " does not end",
                            "the file may have been cut short");
    }

    /// Reads entities, from the group with the type of the first on, up to the end of the section or block.
    bool entities(std::vector<DxfEntity> &list) {
        while (!(group_.value == "ENDSEC" || group_.value == "ENDBLK")) {
            if (group_.code == 999) {
                if (!step()) {
                    return false;
                }
                continue;
            }
            if (group_.code != 0) {
                return groups_.fail(group_.offset, "bad-syntax",
                                    "expected the type of an entity, found group " + std::to_string(group_.code));
            }
            DxfEntity entity{group_.value, groups_.offset(), groups_.offset()};
            while (step() && group_.code != 0) {
                entity.end = groups_.offset();
            }
            if (!groups_.ok()) {
                return false;
            }
            list.push_back(entity);
        }
        return true;
    }

    bool tables() {
        bool more = step();
        while (more && !(group_.code == 0 && group_.value == "ENDSEC")) {
            more = group_.code == 0 && group_.value == "LAYER" ? layer() : step();
        }
        return groups_.ok();
    }

    bool layer() {
        constexpr int kFrozen = 1;
        DxfLayer layer;
        bool more = step();
        for (; more && group_.code != 0; more = step()) {
            switch (group_.code) {
            case 2:
                layer.name = file_.encoding.name(group_.value);
                break;
            case 70:
                layer.frozen = (integerOf(group_.value, 0) & kFrozen) != 0;
                break;
            case 62: // the colour
                layer.off = integerOf(group_.value, 7) < 0;
                break;
            default:
                break;
            }
        }
        file_.layers.emplace(lowerCase(layer.name), std::move(layer));
        return more;
    }

    bool blocks() {
        bool more = step();
        while (more && !(group_.code == 0 && group_.value == "ENDSEC")) {
            more = group_.code == 0 && group_.value == "BLOCK" ? block() : step();
        }
        return groups_.ok();
    }

    bool block() {
        constexpr int kExternal = 4 | 8 | 16; // of the flags: external references
        DxfBlock block;
        std::string name;
        bool more = step();
        for (; more && group_.code != 0; more = step()) {
            if (group_.code == 2) {
                name = file_.encoding.name(group_.value);
            } else if (group_.code == 70) {
                block.external = (integerOf(group_.value, 0) & kExternal) != 0;
            } else if (group_.code == 10 || group_.code == 20) {
                const auto value = parseReal(group_.value);
                if (!value) {
                    return groups_.fail(group_.offset, "bad-number",
                                        "expected a number for the base point of a block, found " +
                                            inQuotes(group_.value));
                }
                (group_.code == 10 ? block.base.x : block.base.y) = *value;
            }
        }
        more = more && entities(block.entities);
        file_.blocks.emplace(lowerCase(name), std::move(block));
        return more;
    }

    const SourceText &source_;
    DxfGroups groups_;
    DxfGroup group_;
    std::string_view name_; ///< of the section
    std::size_t place_ = 0; ///< where it begins
    DxfFile file_;
};

} // namespace

Result<DxfFile> readDxfFile(const SourceText &source) {
    return DxfFileReader(source).read();
}

std::string dxfKey(const DxfFile &file, std::string_view name) {
    return lowerCase(file.encoding.name(name));
}

} // namespace forefront
