// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Memory for programs with the address sanitizer that use OpenFOAM's own libraries; linked by tests/Alltest foamSanitizers alone.
#include <sanitizer/asan_interface.h>

#include <cstdlib>
#include <new>

// The libraries are compiled without the sanitizer, and their loops over vectors load two numbers at a time: one number past the end
// of a field with an even number of vectors. Nothing is done with it, but where the sanitizer's memory ends there the program does, in
// one run of three. So what is allocated is followed by some bytes that may be loaded; our own code is still told that it may not.
// (Lists of OpenFOAM are also deleted as their base class without a virtual destructor: sizes are not compared here.)

namespace
{

constexpr std::size_t padding = 16;   // [bytes] what one instruction of the portable x86-64 loads

void* paddedMemory(std::size_t size)
{
    void* memory = std::malloc(size + padding);
    if (memory) ASAN_POISON_MEMORY_REGION(static_cast<char*>(memory) + size, padding);
    return memory;
}

void* paddedMemoryOrThrow(std::size_t size)
{
    void* memory = paddedMemory(size);
    if (!memory) throw std::bad_alloc();
    return memory;
}

} // namespace

void* operator new(std::size_t size) { return paddedMemoryOrThrow(size); }
void* operator new[](std::size_t size) { return paddedMemoryOrThrow(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return paddedMemory(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return paddedMemory(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
