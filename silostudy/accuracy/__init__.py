"""Cost of accuracy in time: ladders of settings, reference problems, measured fronts, prices of effects, peers."""
