// Headers of other projects are precompiled with a target, and a target has a source.
