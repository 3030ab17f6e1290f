"""What is believed, expected and seen: verdicts, progress, failures, the claim, and notes about them."""
