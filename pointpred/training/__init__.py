"""How the coefficients of the learned predictor are made from recordings, and how well they carry over."""
