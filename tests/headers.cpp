// The precompiled headers of this target serve all tests.
