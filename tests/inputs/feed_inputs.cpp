// Feeds the readers of Riffle with inputs, many in one process, and tells which of them a reader does not
// survive. Deterministic: the same options give the same inputs.
//
//   feed_inputs case|csv|stl --corpus DIR                  each file of a folder, once
//   feed_inputs case|csv|stl --runs N [--seed S] [--from I] --seeds PATH... [--out DIR]
//
// A failure is: a crash or a report of a sanitizer; an exception that is no riffle::Error; a message that
// does not begin with the place; what feed.hpp says of inputs that are taken; more memory than `most_bytes`;
// more work than `most_work` basic blocks, where the program is built to count them. Failing inputs are
// written to
// --out (default: here); the one that a crash stands on, too. Exit status: 0 without a failure, else 1.

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>
#include <sstream>

#include "base/parallel.hpp"
#include "feed.hpp"
#include "mutation.hpp"

namespace {

/// Memory that an input may take beside itself: what the largest right input takes, some times over.
constexpr std::size_t most_bytes = 300U << 20U;
constexpr std::size_t most_bytes_per_byte = 500;
/// Work that an input may take: a second or two. The ordinary case takes some millions of basic blocks.
constexpr std::uint64_t most_work = 2'000'000'000;

/// A builtin counts it: an atomic's functions are basic blocks themselves, which would count without end.
std::uint64_t work = 0;
std::atomic<std::size_t> held{0};
std::atomic<std::size_t> most_held{0};

void count_taken(void* block) {
    const std::size_t now = held.fetch_add(malloc_usable_size(block)) + malloc_usable_size(block);
    if (now > most_held.load()) most_held.store(now);
}

}  // namespace

// Compiled with -fsanitize-coverage=trace-pc, each basic block calls this.
extern "C" __attribute__((no_sanitize_coverage)) void __sanitizer_cov_trace_pc();  // NOLINT
extern "C" void __sanitizer_cov_trace_pc() {
    __atomic_store_n(&work, __atomic_load_n(&work, __ATOMIC_RELAXED) + 1, __ATOMIC_RELAXED);
}

// For the temporary buffers of the standard library's sorts too.
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
    void* const block = std::malloc(size);  // NOLINT(cppcoreguidelines-owning-memory)
    if (block != nullptr) count_taken(block);
    return block;
}
void* operator new(std::size_t size) {
    void* const block = operator new(size, std::nothrow);
    if (block == nullptr) throw std::bad_alloc();
    return block;
}
void operator delete(void* block) noexcept {
    if (block != nullptr) {
        held.fetch_sub(malloc_usable_size(block));
        std::free(block);  // NOLINT(cppcoreguidelines-owning-memory)
    }
}
void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

namespace riffle::inputs {

namespace {

namespace fs = std::filesystem;

struct Options {
    Kind kind = Kind::case_file;
    std::string kind_name;
    fs::path corpus;
    std::vector<fs::path> seeds;
    std::size_t runs = 0;
    std::size_t from = 0;
    std::uint64_t seed = 1;
    fs::path out = ".";
};

std::string content_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

// What is fed now, for the handler of a crash.
std::array<char, 4096> crash_file{};
const std::string* fed = nullptr;

extern "C" void keep_input(int signal_number) {
    const int file = open(crash_file.data(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file >= 0 && fed != nullptr) {
        static_cast<void>(!write(file, fed->data(), fed->size()));
        close(file);
    }
    std::signal(signal_number, SIG_DFL);
    static_cast<void>(raise(signal_number));
}

void catch_crashes() {
    static std::array<char, 1U << 16U> stack_of_handler;
    stack_t stack{};
    stack.ss_sp = stack_of_handler.data();
    stack.ss_size = stack_of_handler.size();
    sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = keep_input;
    action.sa_flags = static_cast<int>(SA_ONSTACK);
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        sigaction(number, &action, nullptr);
    }
}

Answer feed(Kind kind, const std::string& input, const fs::path& folder) {
    switch (kind) {
        case Kind::case_file:
            return feed_case(input, folder);
        case Kind::csv:
            return feed_csv(input);
        case Kind::stl:
            return feed_stl(input);
    }
    return Answer::refused;
}

class Feeder {
  public:
    explicit Feeder(const Options& options) : options_(options) {
        folder_ = fs::temp_directory_path() / ("riffle-inputs-" + std::to_string(getpid()));
        fs::create_directories(folder_);
        std::ofstream(folder_ / "box.stl", std::ios::binary) << stl_seeds().front();
        std::ofstream(folder_ / "profile.csv") << "z [mm], u [m/s]\n10, 0.2\n20, 0.3\n30, 0.33\n";
        fs::create_directories(options.out);
    }
    ~Feeder() { fs::remove_all(folder_); }
    Feeder(const Feeder&) = delete;
    Feeder& operator=(const Feeder&) = delete;
    Feeder(Feeder&&) = delete;
    Feeder& operator=(Feeder&&) = delete;

    void take(const std::string& input, const std::string& name) {
        const fs::path kept = options_.out / (options_.kind_name + "-" + name);
        std::snprintf(crash_file.data(), crash_file.size(), "%s", kept.c_str());
        fed = &input;
        const std::size_t before = held.load();
        most_held.store(before);
        __atomic_store_n(&work, 0, __ATOMIC_RELAXED);
        std::string wrong;
        try {
            (feed(options_.kind, input, folder_) == Answer::taken ? taken_ : refused_) += 1;
        } catch (const Failure& failure) {
            wrong = failure.what();
        } catch (const std::exception& error) {
            wrong = std::string("an unexpected exception: ") + error.what();
        }
        const std::uint64_t done = __atomic_load_n(&work, __ATOMIC_RELAXED);
        const std::size_t bytes = most_held.load() - before;
        most_work_ = std::max(most_work_, done);
        most_bytes_ = std::max(most_bytes_, bytes);
        if (wrong.empty() && done > most_work) {
            wrong = fmt::format("{} basic blocks of work", done);
        }
        if (wrong.empty() && bytes > most_bytes + most_bytes_per_byte * input.size()) {
            wrong = fmt::format("{} bytes of memory", bytes);
        }
        fed = nullptr;
        if (!wrong.empty()) {
            ++failures_;
            if (options_.corpus.empty()) std::ofstream(kept, std::ios::binary) << input;
            fmt::print("FAILURE {}: {}\n", options_.corpus.empty() ? kept.string() : name,
                       wrong.substr(0, 3000));
            std::fflush(stdout);
        }
    }

    [[nodiscard]] int conclude() const {
        fmt::print(
            "{}: {} taken, {} refused, {} failures; at most {:.3g} basic blocks and {:.3g} MB an input\n",
            options_.kind_name, taken_, refused_, failures_, static_cast<double>(most_work_),
            1e-6 * static_cast<double>(most_bytes_));
        return failures_ == 0 && taken_ + refused_ > 0 ? 0 : 1;
    }

  private:
    const Options& options_;
    fs::path folder_;
    std::size_t taken_ = 0;
    std::size_t refused_ = 0;
    std::size_t failures_ = 0;
    std::uint64_t most_work_ = 0;
    std::size_t most_bytes_ = 0;
};

/// The files of a folder and those below it that may be inputs of a kind, by name.
std::vector<fs::path> files_in(const fs::path& path, Kind kind) {
    if (fs::is_regular_file(path)) {
        return {path};
    }
    const std::string ending = kind == Kind::case_file ? ".toml" : kind == Kind::csv ? ".csv" : ".stl";
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
        if (entry.is_regular_file() && entry.path().extension() == ending) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The first lines of a long record do as well as all of it.
std::string shortened(std::string text) {
    constexpr std::size_t enough = 6000;
    const std::size_t end = text.size() <= enough ? std::string::npos : text.find('\n', enough);
    return end == std::string::npos ? text : text.substr(0, end + 1);
}

int run(const Options& options) {
    set_thread_count(1);
    catch_crashes();
    Feeder feeder(options);
    if (!options.corpus.empty()) {
        for (const auto& entry : files_in(options.corpus, options.kind)) {
            feeder.take(content_of(entry), entry.filename().string());
        }
        return feeder.conclude();
    }
    std::vector<std::string> seeds = options.kind == Kind::stl ? stl_seeds() : std::vector<std::string>();
    for (const fs::path& path : options.seeds) {
        for (const fs::path& file : files_in(path, options.kind)) {
            const std::string text = content_of(file);
            seeds.push_back(options.kind == Kind::csv ? shortened(text) : text);
        }
    }
    if (seeds.empty()) {
        fmt::print(stderr, "feed_inputs: no seeds: give --seeds\n");
        return 2;
    }
    // Each input has a generator of its own, so that --from repeats a single one.
    for (std::size_t i = options.from; i < options.from + options.runs; ++i) {
        const std::string input = Mutator(options.kind, seeds, options.seed * 0x9e3779b97f4a7c15U + i).next();
        feeder.take(input, fmt::format("{}-{}", options.seed, i));
    }
    return feeder.conclude();
}

std::optional<Options> read_options(const std::vector<std::string>& words) {
    Options options;
    if (words.empty()) return std::nullopt;
    options.kind_name = words[0];
    if (words[0] == "case") {
        options.kind = Kind::case_file;
    } else if (words[0] == "csv") {
        options.kind = Kind::csv;
    } else if (words[0] == "stl") {
        options.kind = Kind::stl;
    } else {
        return std::nullopt;
    }
    for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
        const std::string& option = words[i];
        const std::string& value = words[i + 1];
        if (option == "--corpus") {
            options.corpus = value;
        } else if (option == "--runs") {
            options.runs = std::stoul(value);
        } else if (option == "--from") {
            options.from = std::stoul(value);
        } else if (option == "--seed") {
            options.seed = std::stoul(value);
        } else if (option == "--seeds") {
            options.seeds.emplace_back(value);
        } else if (option == "--out") {
            options.out = value;
        } else {
            return std::nullopt;
        }
    }
    return options;
}

}  // namespace

}  // namespace riffle::inputs

int main(int argc, char** argv) {
    const auto options = riffle::inputs::read_options({argv + 1, argv + argc});
    if (!options) {
        fmt::print(stderr,
                   "usage: feed_inputs case|csv|stl (--corpus DIR | --runs N [--seed S] [--from I] [--seeds "
                   "PATH]... [--out DIR])\n");
        return 2;
    }
    return riffle::inputs::run(*options);
}
