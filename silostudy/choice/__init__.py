"""An accuracy asked for becomes settings: once, after the scenes are known, and before anything is computed."""
