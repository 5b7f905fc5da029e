"""Sources that several laws share, by their keys in the references."""

KIYAMA = "kiyama_fujimura_1983"
