// Its precompiled headers serve all tests.
