// Provides the precompiled headers of the engine's libraries.
