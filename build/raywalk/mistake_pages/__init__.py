"""What the pages of mistakes show: where each shows best, its picture, its rays beside right."""
