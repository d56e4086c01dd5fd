#include "core/drawing/recovery/journal_record.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace forefront;
using namespace forefront::edit_test;
using forefront::testing::TemporaryFolder;
using namespace std::chrono_literals;

namespace {

/// Replaces projectText: the size of the document in many words, so that deltas have a common beginning and end.
std::string words(const Document &document) {
    std::string text = "begin ";
    for (std::uint32_t k = 1; k < document.nextId; ++k) {
        text += std::to_string(k) + " ";
    }
    return text + "end";
}

std::shared_ptr<const Document> numbered(std::uint32_t next) {
    Document document;
    document.nextId = next;
    return std::make_shared<const Document>(document);
}

std::string journalOf(const std::vector<std::string> &texts) {
    std::string bytes(kJournalMagic);
    bytes += encodeRecord(JournalRecord::Path, "/home/me/harbour.forefront");
    bytes += encodeRecord(JournalRecord::FullText, texts.front());
    for (std::size_t k = 1; k < texts.size(); ++k) {
        bytes += encodeRecord(JournalRecord::Delta, encodeDelta(texts[k - 1], texts[k]));
    }
    return bytes;
}

} // namespace

TEST_CASE("Journal: a delta of any two texts gives the second from the first") {
    Random random(7);
    for (int k = 0; k < 2000; ++k) {
        std::string before, after;
        for (std::uint32_t n = random.below(12); n > 0; --n) {
            before += static_cast<char>('a' + random.below(2));
        }
        for (std::uint32_t n = random.below(12); n > 0; --n) {
            after += static_cast<char>('a' + random.below(2));
        }
        REQUIRE(readJournal(journalOf({before, after})).text == after);
    }
}

TEST_CASE("Journal: truncated at any byte, it gives the newest complete text") {
    const std::vector<std::string> texts{"one", "one two", "on two", "", "three"};
    const std::string bytes = journalOf(texts);
    std::size_t next = 0;
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
        const JournalContent content = readJournal(std::string_view(bytes).substr(0, cut));
        CHECK(content.validBytes <= cut);
        if (next < texts.size() && content.text == texts[next]) {
            ++next;
        }
        if (next == 0) {
            REQUIRE_FALSE(content.text.has_value());
        } else {
            REQUIRE(content.text == texts[next - 1]);
            REQUIRE(content.path == "/home/me/harbour.forefront");
        }
    }
    CHECK(next == texts.size());
}

TEST_CASE("Journal: a flipped bit ends it at the previous record") {
    const std::vector<std::string> texts{"one", "one two", "one two three"};
    const std::string bytes = journalOf(texts);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        std::string spoilt = bytes;
        spoilt[bit / 8] = static_cast<char>(spoilt[bit / 8] ^ (1 << (bit % 8)));
        const JournalContent content = readJournal(spoilt);
        REQUIRE(content.validBytes <= bit / 8);
        REQUIRE((!content.text || *content.text == texts[0] || *content.text == texts[1]));
    }
}

TEST_CASE("Journal: after a save there is nothing to recover, after the next change there is") {
    std::string bytes = journalOf({"one"}) + encodeRecord(JournalRecord::Saved, {});
    CHECK_FALSE(readJournal(bytes).text.has_value());
    bytes += encodeRecord(JournalRecord::Delta, encodeDelta("one", "two"));
    CHECK(readJournal(bytes).text == "two");
}

TEST_CASE("RecoveryJournal: no file before the first change, none after a clean end") {
    const TemporaryFolder folder;
    {
        RecoveryJournal journal(folder.path / "state", words);
        journal.recordSaved();
        journal.flush();
        CHECK(folder.fileCount() == 0);
        journal.record(numbered(5), {});
        journal.flush();
        CHECK(std::filesystem::exists(journal.file()));
        CHECK(findOrphanedJournals(folder.path / "state").empty());
        CHECK(std::filesystem::exists(journal.file()));
        CHECK(journal.takeFaults().empty());
    }
    CHECK(std::filesystem::is_empty(folder.path / "state"));
}

TEST_CASE("RecoveryJournal: the file holds the newest document, however long it gets") {
    const TemporaryFolder folder;
    RecoveryJournal journal(folder.path, [](const Document &document) {
        // Two texts with nothing in common: every delta is as long as the text, so the file is rewritten now and then.
        return std::string(300000, document.nextId % 2 == 0 ? 'a' : 'b') + std::to_string(document.nextId);
    });
    for (std::uint32_t k = 1; k < 20; ++k) {
        journal.record(numbered(k), {"/tmp/x.forefront", "", 77});
        journal.flush();
        std::ifstream file(journal.file(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        const JournalContent content = readJournal(bytes);
        REQUIRE(content.text.has_value());
        CHECK(content.text->substr(300000) == std::to_string(k));
        CHECK(content.path == "/tmp/x.forefront");
        CHECK(content.savedHash == 77);
        CHECK(bytes.size() < 3000000);
    }
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("RecoveryJournal: a folder that cannot be made is reported once") {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "state") << "a file in the way";
    RecoveryJournal journal(folder.path / "state", words);
    for (std::uint32_t k = 1; k < 4; ++k) {
        journal.record(numbered(k), {});
        journal.flush();
    }
    const Diagnostics faults = journal.takeFaults();
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].code == "journal-failed");
    CHECK(journal.takeFaults().empty());
}

TEST_CASE("RecoveryJournal: a killed program loses at most the last second, whether saved before or not") {
    for (const char *savedAt : {"", "/home/me/harbour.forefront"}) {
        const TemporaryFolder folder;
        int ready[2];
        REQUIRE(::pipe(ready) == 0);
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            RecoveryJournal journal(folder.path, words);
            for (std::uint32_t k = 1; k <= 50; ++k) {
                journal.record(numbered(k), {savedAt, {}, 0});
                std::this_thread::sleep_for(1ms);
            }
            const char byte = 1;
            if (::write(ready[1], &byte, 1) != 1) {
                ::_exit(1);
            }
            ::pause();
        }
        char byte = 0;
        REQUIRE(::read(ready[0], &byte, 1) == 1);
        CHECK(findOrphanedJournals(folder.path).empty()); // it lives
        std::this_thread::sleep_for(1s);
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        ::close(ready[0]);
        ::close(ready[1]);

        std::vector<OrphanedJournal> orphans = findOrphanedJournals(folder.path);
        REQUIRE(orphans.size() == 1);
        CHECK(orphans[0].text() == words(*numbered(50)));
        CHECK(orphans[0].savedAt() == savedAt);
        CHECK(findOrphanedJournals(folder.path).empty()); // held while it is offered
        orphans[0].discard();
        CHECK(folder.fileCount() == 0);
    }
}

TEST_CASE("findOrphanedJournals: newest first; removes empty and corrupt ones and leaves other files alone") {
    const TemporaryFolder folder;
    const auto put = [&](const char *name, const std::string &bytes, int age) {
        std::ofstream(folder.path / name, std::ios::binary) << bytes;
        std::filesystem::last_write_time(folder.path / name,
                                         std::filesystem::file_time_type::clock::now() - std::chrono::hours(age));
    };
    put("1-0.journal", journalOf({"old"}), 5);
    put("2-0.journal", journalOf({"new"}), 1);
    put("3-0.journal", "", 1);
    put("4-0.journal", "rubbish that is no journal at all", 1);
    put("5-0.journal", journalOf({"saved"}) + encodeRecord(JournalRecord::Saved, {}), 1);
    put("notes.txt", "mine", 1);
    {
        const std::vector<OrphanedJournal> orphans = findOrphanedJournals(folder.path);
        REQUIRE(orphans.size() == 2);
        CHECK(orphans[0].text() == "new");
        CHECK(orphans[1].text() == "old");
    }
    CHECK(folder.fileCount() == 3);
    CHECK(findOrphanedJournals(folder.path / "nowhere").empty());
}
