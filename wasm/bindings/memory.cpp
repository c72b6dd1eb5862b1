#include <emscripten/bind.h>

#include <malloc.h>
#include <unistd.h>

#include <cstdint>

namespace {

/// Highest address ever handed out: linear memory never shrinks, so this is the peak of the worker's life.
double peak_bytes() { return static_cast<double>(reinterpret_cast<std::uintptr_t>(sbrk(0))); }

/// Bytes allocated right now.
double live_bytes() { return static_cast<double>(static_cast<std::size_t>(mallinfo().uordblks)); }

} // namespace

EMSCRIPTEN_BINDINGS(memory) {
    emscripten::function("peakBytes", &peak_bytes);
    emscripten::function("liveBytes", &live_bytes);
}
