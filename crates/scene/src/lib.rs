//! What a scene says about its cloud layer, its sun and its camera.
