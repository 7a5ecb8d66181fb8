// A target needs a source. This one is for the target that precompiles headers of other projects.
