#pragma once

/// \file
/// \brief Whether the world is compiled in every source, or once.

// What takes long to compile, the members of GameWorld and solver_named(), is compiled in every
// source that includes it; or once, if all sources are compiled with COOKBOOK_WORLD_COMPILED and
// one of them begins with #define COOKBOOK_WORLD_SOURCE.
#ifdef COOKBOOK_WORLD_COMPILED
#define COOKBOOK_WORLD_INLINE
#else
#define COOKBOOK_WORLD_INLINE inline
#endif
#if !defined(COOKBOOK_WORLD_COMPILED) || defined(COOKBOOK_WORLD_SOURCE)
#define COOKBOOK_WORLD_BODIES 1
#else
#define COOKBOOK_WORLD_BODIES 0
#endif
