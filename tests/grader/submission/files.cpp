// Folders by the file system, archives by libarchive.
// SPDX-License-Identifier: MIT
#include "grader/submission/files.hpp"

#include "grader/report/text.hpp"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <cctype>
#include <fcntl.h>
#include <initializer_list>
#include <locale.h>
#include <memory>
#include <stdexcept>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace grader {

namespace {

namespace fs = std::filesystem;

bool endsIn(const std::string& name, std::initializer_list<const char*> ends);

// What a submission is made of. Files that begin with a dot are an editor's or a system's (zips of macOS bring ._lesson.cpp along).
bool isSource(const std::string& name) {
    const bool hidden = fs::path(name).filename().string().starts_with('.');
    return !hidden && endsIn(name, {".cpp", ".cc", ".cxx", ".hpp", ".h", ".glsl", ".vert", ".frag"});
}

// Keeps count of what is taken.
class Taker {
  public:
    Taker(Files& files, Language language) : files_(files), language_(language) {}

    void leave(const std::string& name, const char* note, long long bytes) {
        if (files_.leftOut.size() < mostFiles)
            files_.leftOut.push_back({name, "leftOut", note, bytes, ""});
    }
    /// Whether the name is of interest and there is room for one more; if not, it is left out.
    bool room(const std::string& name, long long bytes) {
        const std::size_t largest = isArchive(name) ? largestArchive : largestFile;
        if (!isSource(name) && !isArchive(name))
            leave(name, "", bytes);
        else if (files_.taken.size() >= mostFiles)
            leave(name, say(language_, "too many files: at most 200", "troppi file: al massimo 200"), bytes);
        else if (bytes < 0 || static_cast<std::size_t>(bytes) > largest)
            leave(name, say(language_, "too large", "troppo grande"), bytes);
        else if (!isArchive(name) && total_ + static_cast<std::size_t>(bytes) > largestTotal)
            leave(name, say(language_, "too much in all: at most 8 MiB", "troppo in tutto: al massimo 8 MiB"),
                  bytes);
        else
            return true;
        return false;
    }
    void take(const std::string& name, std::string text) {
        if (isSource(name) &&
            text.starts_with("\xEF\xBB\xBF"))  // an editor's mark, which no GLSL compiler takes
            text.erase(0, 3);
        total_ += text.size();
        files_.taken.push_back({name, std::move(text)});
    }

  private:
    Files& files_;
    Language language_;
    std::size_t total_ = 0;
};

bool endsIn(const std::string& name, std::initializer_list<const char*> ends) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(ends.begin(), ends.end(), [&](const char* end) { return lower.ends_with(end); });
}

// Opened without following a link or waiting for a pipe, and read up to the limit.
std::optional<std::string> readPlain(const fs::path& path, std::size_t largest) {
    const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return std::nullopt;
    const std::unique_ptr<const int, void (*)(const int*)> closer(&file, [](const int* f) { close(*f); });
    struct stat status {};
    if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode))
        return std::nullopt;
    std::string text;
    char buffer[65536];
    for (ssize_t got = 0; (got = read(file, buffer, sizeof buffer)) > 0 && text.size() <= largest;)
        text.append(buffer, static_cast<std::size_t>(got));
    return text;
}

void takeFile(Taker& taker, const fs::path& path, const std::string& name, Language language) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (status.type() != fs::file_type::regular) {
        taker.leave(
            name,
            say(language, "no plain file (a link, a pipe)", "nessun file vero e proprio (un link, una pipe)"),
            0);
        return;
    }
    const std::uintmax_t bytes = fs::file_size(path, error);
    if (!taker.room(name,
                    error ? -1 : static_cast<long long>(std::min<std::uintmax_t>(bytes, largestArchive + 1))))
        return;
    if (std::optional<std::string> text = readPlain(path, isArchive(name) ? largestArchive : largestFile))
        taker.take(name, std::move(*text));
    else
        taker.leave(name, say(language, "cannot be read", "non si legge"), static_cast<long long>(bytes));
}

void sortByName(Files& files) {
    std::sort(files.taken.begin(), files.taken.end(),
              [](const NamedText& a, const NamedText& b) { return a.name < b.name; });
    std::sort(files.leftOut.begin(), files.leftOut.end(),
              [](const SubmittedFile& a, const SubmittedFile& b) { return a.path < b.path; });
}

void takeFolder(Taker& taker, const fs::path& folder, Language language) {
    std::error_code error;
    fs::recursive_directory_iterator entries(folder, error);
    if (error)
        throw std::runtime_error(folder.string() + ": " + error.message() +
                                 "; expected a folder, an archive or a file");
    std::size_t seen = 0;
    while (entries != fs::recursive_directory_iterator() && ++seen <= 100 * mostFiles) {
        const fs::directory_entry entry = *entries;
        if (entries.depth() > 16)
            entries.disable_recursion_pending();
        const fs::file_type type = entry.symlink_status(error).type();
        if (type != fs::file_type::directory)
            takeFile(taker, entry.path(), entry.path().lexically_relative(folder).string(), language);
        entries.increment(error);
        if (error)
            break;
    }
}

// libarchive says names in the thread's locale, and in "C" it has none for an accent.
class Utf8 {
  public:
    Utf8() : own_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), before_(uselocale(own_)) {}
    ~Utf8() {
        uselocale(before_);
        if (own_ != nullptr)
            freelocale(own_);
    }
    Utf8(const Utf8&) = delete;
    Utf8& operator=(const Utf8&) = delete;

  private:
    locale_t own_, before_;
};

// The entry's bytes up to the limit, or nothing if they are more or broken.
std::optional<std::string> contentOf(archive* in) {
    std::string text;
    char buffer[65536];
    for (la_ssize_t got = 0; (got = archive_read_data(in, buffer, sizeof buffer)) != 0;) {
        if (got < 0)
            return std::nullopt;
        text.append(buffer, static_cast<std::size_t>(got));
        if (text.size() > largestFile)
            break;
    }
    return text;
}

}  // namespace

bool isArchive(const std::string& name) {
    return !fs::path(name).filename().string().starts_with('.') &&
           endsIn(name, {".zip", ".tar", ".tar.gz", ".tgz"});
}

Files filesInArchive(const std::string& bytes, Language language) {
    const Utf8 names;
    Files files;
    Taker taker(files, language);
    const std::unique_ptr<archive, int (*)(archive*)> in(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(in.get());
    archive_read_support_format_tar(in.get());
    archive_read_support_filter_gzip(in.get());
    const auto broken = [&] {
        const char* why = archive_error_string(in.get());
        files.problem = std::string(say(language, "the archive cannot be read", "l'archivio non si legge")) +
                        (why == nullptr ? "" : ": " + std::string(why));
    };
    if (archive_read_open_memory(in.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) {
        broken();
        return files;
    }
    archive_entry* entry = nullptr;
    int status = ARCHIVE_OK;
    for (std::size_t seen = 0;
         (status = archive_read_next_header(in.get(), &entry)) == ARCHIVE_OK || status == ARCHIVE_WARN;) {
        if (++seen > 10 * mostFiles)
            break;
        const char* path = archive_entry_pathname(entry);
        const std::string name = path == nullptr ? "?" : path;
        if (archive_entry_filetype(entry) == AE_IFDIR)
            continue;
        if (archive_entry_filetype(entry) != AE_IFREG) {
            taker.leave(name,
                        say(language, "no plain file (a link, a pipe)",
                            "nessun file vero e proprio (un link, una pipe)"),
                        0);
            continue;
        }
        std::optional<std::string> text = contentOf(in.get());
        if (!text)
            taker.leave(name, say(language, "cannot be read", "non si legge"), 0);
        else if (taker.room(name, static_cast<long long>(text->size())))
            taker.take(name, std::move(*text));
    }
    if (status != ARCHIVE_EOF && status != ARCHIVE_OK && status != ARCHIVE_WARN && files.taken.empty())
        broken();
    sortByName(files);
    return files;
}

Files filesAt(const fs::path& path, Language language) {
    std::error_code error;
    const fs::file_type type = fs::status(path, error).type();
    Files files;
    Taker taker(files, language);
    if (type == fs::file_type::directory)
        takeFolder(taker, path, language);
    else if (type == fs::file_type::regular)
        takeFile(taker, fs::canonical(path), path.filename().string(), language);
    else
        throw std::runtime_error(path.string() + ": expected a folder, an archive or a file, found " +
                                 (type == fs::file_type::not_found ? "nothing" : "something else"));
    sortByName(files);
    return files;
}

}  // namespace grader
