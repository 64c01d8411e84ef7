// Its precompiled headers serve the libraries of the engine.
